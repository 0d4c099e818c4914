"""What the exit code of a command says."""

from __future__ import annotations

from collections.abc import Iterable

from ..diagnostics import Diagnostic

DONE = 0
SCENARIO_HAS_ERRORS = 1
WRONG_USE = 2
NO_SCENE = 3
EXPECTATION_BROKEN = 4
OUTSIDE_PART_FAILED = 5
BUG = 70
INTERRUPTED = 130
PIPE_CLOSED = 141
TERMINATED = 143

_BY_PREFIX = (
    ("RL900", BUG),
    ("RL92", WRONG_USE),
    ("RL93", WRONG_USE),
    ("RL460", WRONG_USE),
    ("RL211", OUTSIDE_PART_FAILED),
    ("RL470", OUTSIDE_PART_FAILED),
    ("RL474", OUTSIDE_PART_FAILED),
    ("RL5", OUTSIDE_PART_FAILED),
    ("RL60", NO_SCENE),
)
_SCENARIO_CODES_AMONG_THEM = ("RL922", "RL923")
_SEVEREST_FIRST = (BUG, OUTSIDE_PART_FAILED, WRONG_USE, NO_SCENE, SCENARIO_HAS_ERRORS, DONE)


def exit_code_of(diagnostics: Iterable[Diagnostic]) -> int:
    """The exit code that the errors among the diagnostics call for; `DONE` without errors."""
    codes = {_exit_code(diagnostic.code) for diagnostic in diagnostics if diagnostic.is_error}
    return next((code for code in _SEVEREST_FIRST if code in codes), DONE)


def _exit_code(code: str) -> int:
    if code in _SCENARIO_CODES_AMONG_THEM:
        return SCENARIO_HAS_ERRORS
    found = (meaning for prefix, meaning in _BY_PREFIX if code.startswith(prefix))
    return next(found, SCENARIO_HAS_ERRORS)
