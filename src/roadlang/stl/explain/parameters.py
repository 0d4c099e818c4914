"""Parameters of formulas and the recordings that they are mined from."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ...diagnostics import arguments
from ..evaluate.trace import Positions, Signals

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
    """The recordings. Raises `TypeError` for anything else than text, parameters and recordings."""
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
    return pairs
