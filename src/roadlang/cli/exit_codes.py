"""What the exit code of a command says."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..diagnostics import Diagnostic

DONE = 0
SCENARIO_HAS_ERRORS = 1
WRONG_USE = 2
NO_SCENE = 3
EXPECTATION_VIOLATED = 4
OUTSIDE_PART_FAILED = 5
BUG = 70
INTERRUPTED = 130
PIPE_CLOSED = 141
TERMINATED = 143

_SEVEREST_FIRST = (
    BUG, OUTSIDE_PART_FAILED, WRONG_USE, NO_SCENE, SCENARIO_HAS_ERRORS, EXPECTATION_VIOLATED, DONE
)  # fmt: skip


def exit_code_of(diagnostics: Iterable[Diagnostic]) -> int:
    """The exit code that the errors among the diagnostics call for, as their pages in the catalog
    have it; `DONE` without errors."""
    return severest(_exit_code(found.code) for found in diagnostics if found.is_error)


def severest(codes: Iterable[int]) -> int:
    """The most severe of several exit codes; `DONE` without any."""
    present = set(codes)
    return next((code for code in _SEVEREST_FIRST if code in present), DONE)


def _exit_code(code: str) -> int:
    from ..diagnostics import UnknownCode, page

    try:
        return page(code).exit
    except UnknownCode:  # of a plugin, which has no page in the catalog
        return SCENARIO_HAS_ERRORS
