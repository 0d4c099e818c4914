"""Parameters of formulas and the recordings that they are mined from."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ...diagnostics import Code, arguments, did_you_mean
from ...syntax.words import NOT_NAMES
from ..errors import stl_error
from ..evaluate.trace import Positions, Signals
from ..formula.terms import number_text

_NAME = re.compile(r"[A-Za-z_]\w*")
_WORD = re.compile(rf"(?<![\w.]){_NAME.pattern}(?![\w.])")

Recording = tuple[Positions, Signals]


@dataclass(frozen=True)
class Parameter:
    """A name in the text of a formula that stands for a number between `low` and `high`."""

    name: str
    low: float
    high: float

    def __post_init__(self) -> None:
        arguments.text("name", self.name)
        arguments.number("low", self.low)
        arguments.number("high", self.high)


def checked(
    text: str, parameters: Sequence[Parameter], recordings: Iterable[Recording]
) -> tuple[Recording, ...]:
    """The recordings. Raises `TypeError` for anything else than text, parameters and recordings,
    DiagnosticError RL300 where there is no recording, RL342 for parameters that the text does not
    have, that are given twice, that a recording has as signals, or without finite bounds in order.
    """
    arguments.text("text", text)
    are_parameters = isinstance(parameters, Sequence) and all(
        isinstance(parameter, Parameter) for parameter in parameters
    )
    if not are_parameters or not parameters:
        raise arguments.wrong_type("parameters", "a list of `Parameter`s", parameters)
    pairs = tuple(recordings) if isinstance(recordings, Iterable) else ()
    are_pairs = all(isinstance(pair, Sequence) and len(pair) == 2 for pair in pairs)
    if not (are_pairs and isinstance(recordings, Iterable)):
        raise arguments.wrong_type("recordings", "a list of pairs (positions, signals)", recordings)
    if not pairs:
        raise stl_error(Code.EMPTY_TRACE)
    signals = {name for _, columns in pairs for name in columns}
    names = [parameter.name for parameter in parameters]
    for parameter in parameters:
        _check_bounds(parameter)
        if names.count(parameter.name) > 1:
            raise _wrong(parameter.name, "it is given twice")
        _check_name(parameter.name, text, signals)
    return pairs


def _check_bounds(parameter: Parameter) -> None:
    """Finite, in order, and not so far apart that their distance is infinite."""
    name, low, high = parameter.name, parameter.low, parameter.high
    if math.isfinite(high - low) and low < high:
        return
    help = "its bounds are two finite numbers, the lower one first"
    if math.isfinite(low) and math.isfinite(high) and math.isinf(high - low):
        help = "they are too far apart: their distance is too large for a number"
    elif math.isfinite(high - low) and low > high:
        help = f"the lower one comes first: `{name}={number_text(high)}..{number_text(low)}`"
    raise _wrong(name, f"its bounds are {number_text(low)} and {number_text(high)}", help)


def _check_name(name: str, text: str, signals: set[str]) -> None:
    if not _NAME.fullmatch(name):
        raise _wrong(name, "it is not a name", "a name is a word, as in `limit=0..20`")
    if name in NOT_NAMES:
        raise _wrong(name, "it is a word of formulas", "give the parameter another name")
    if name in signals:
        help = "signals have their values from the trace: give the parameter another name"
        raise _wrong(name, "it is a signal of the trace", help)
    if not word_pattern(name).search(text):
        near = did_you_mean(name, {*_WORD.findall(text)} - signals)
        raise _wrong(name, "the formula does not contain it", near)


def _wrong(name: str, problem: str, help: str | tuple[str, ...] = ()) -> Exception:
    return stl_error(Code.INVALID_PARAMETER, name=name, problem=problem, help=help)


def word_pattern(name: str) -> re.Pattern[str]:
    """Matches a name where it stands alone, not as a part of `ego.speed` or of another word."""
    return re.compile(rf"(?<![\w.]){re.escape(name)}(?![\w.])")
