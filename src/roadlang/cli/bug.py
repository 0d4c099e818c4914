"""An unexpected exception, as a short report."""

from __future__ import annotations

import platform
import traceback

from ..diagnostics import Code, Diagnostic, diagnose
from ..version import __version__


def describe_bug(error: BaseException) -> Diagnostic:
    """What happened and where in roadlang, in the form of a diagnostic (RL900)."""
    frames = traceback.extract_tb(error.__traceback__)
    where = f"{frames[-1].filename}:{frames[-1].lineno}" if frames else "an unknown place"
    what = f"{type(error).__name__}: {error}".strip().splitlines()[0][:300]
    return diagnose(
        Code.INTERNAL_ERROR,
        help=(
            f"this is a bug in roadlang {__version__} (Python {platform.python_version()}),"
            f" at {where}",
            "please report it with the scene file; ROADLANG_TRACEBACK=1 shows the traceback",
        ),
        what=what,
    )
