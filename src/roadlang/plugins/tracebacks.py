"""Tracebacks of plugins that fail, for their authors."""

from __future__ import annotations

import os

VARIABLE = "ROADLANG_TRACEBACK"


def show_traceback(error: BaseException) -> None:
    """Print it to standard error, where the environment asks for that: at once, since the
    diagnostic that is made of the error may be one of several, or come from another process."""
    if os.environ.get(VARIABLE):
        import traceback

        traceback.print_exception(error)
