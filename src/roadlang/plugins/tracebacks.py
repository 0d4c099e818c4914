"""Tracebacks of plugins that fail, for their authors."""

from __future__ import annotations

import os

VARIABLE = "ROADLANG_TRACEBACK"


def help_of_fault(origin: object) -> tuple[str, ...]:
    """What to do about a plugin that raised: for its users, and for its authors."""
    report = f"this is a fault of the plugin; report it to the authors of {origin}"
    if os.environ.get(VARIABLE):
        return (report,)
    return (report, f"{VARIABLE}=1 in the environment shows its traceback")


def show_traceback(error: BaseException) -> None:
    """Print it to standard error, where the environment asks for that: at once, since the
    diagnostic that is made of the error may be one of several, or come from another process."""
    if os.environ.get(VARIABLE):
        import traceback

        traceback.print_exception(error)
