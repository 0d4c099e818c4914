"""Junctions as a map states them: which lanes lead into which, along which lines, and who goes
first."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

from ..curves.curve import Curve
from .junction_model import End, LaneEnd


@dataclass(frozen=True, eq=False)
class MapTurn:
    """From the end of one lane into another lane. `curve` is the line that is driven, in its
    direction; without one, the two roads meet there and it is drawn from end to end."""

    source: LaneEnd
    target: LaneEnd
    curve: Curve | None = None

    def transformed(self, moved: Callable[[Curve], Curve], mirrors: bool) -> MapTurn:
        """The turn along what became of its curve; lanes change sides if that `mirrors`."""
        ends = (self.source, self.target)
        source, target = (replace(end, lane=-end.lane) if mirrors else end for end in ends)
        return MapTurn(source, target, None if self.curve is None else moved(self.curve))


@dataclass(frozen=True, eq=False)
class MapJunction:
    """The ends of roads that meet in one junction, which need not be at one node, and its turns.

    `joint`: two roads that go on as one another.
    """

    id: int
    arms: tuple[tuple[int, End], ...]
    turns: tuple[MapTurn, ...]
    joint: bool = False

    def transformed(self, moved: Callable[[Curve], Curve], mirrors: bool) -> MapJunction:
        """The junction along what became of its curves."""
        return replace(self, turns=tuple(turn.transformed(moved, mirrors) for turn in self.turns))


@dataclass(frozen=True)
class MapControl:
    """Signals or signs for the traffic of ends of roads: `signals` of a junction, or signs of minor
    roads."""

    rule: Literal["signals", "stop", "yield"]
    arms: tuple[tuple[int, End], ...]
