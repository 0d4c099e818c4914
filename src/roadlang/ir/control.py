"""What a controller written in Python gets and gives, once a step."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from .read_only import Frozen


@dataclass(frozen=True, slots=True)
class Observation(Frozen):
    """The state of one agent, SI units and radians; the line is the one that it should follow.

    `line_ahead(d)` gives x, y, heading and curvature of that line `d` meters on.
    """

    time: float
    step: float
    agent: str
    x: float
    y: float
    heading: float
    speed: float
    steering: float
    cross_track_error: float
    """distance from the line, left positive"""
    heading_error: float
    """own heading minus that of the line"""
    station: float
    wheelbase: float
    line_ahead: Callable[[float], tuple[float, float, float, float]]
    others: Mapping[str, Observation] = field(default_factory=dict)
    """all agents by name, this one too; theirs have no `others`"""


@dataclass(frozen=True, slots=True)
class Control:
    """Steering angle of the front wheels (left positive), acceleration (braking negative)."""

    steering: float
    acceleration: float
