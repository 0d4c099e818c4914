"""What a reward is made of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

from ..geometry.arrays import Booleans, Floats

MOST = 100.0
"""Margins are within this in rewards: an infinite gap to nobody says nothing more."""


@dataclass(frozen=True)
class Transition:
    """What happened to N agents in one step, as columns (N,). SI units and radians."""

    # Most rewards need few of the columns: some are computed when they are first looked at.

    margins: Mapping[str, Floats]
    """of each `expect` over the drive, by name: the robustness now of `p` in `always p`, at most
    100 either way; positive where it is satisfied. `reward` is that of a formula given as reward"""
    moved: Floats
    """meters along the path, in this step"""
    time: Floats
    """since the start of the episode"""
    x: Floats
    y: Floats
    heading: Floats
    speed: Floats
    acceleration: Floats
    yaw_rate: Floats
    steering: Floats
    cross_track_error: Floats
    action: Floats
    """(N, 2) steering and acceleration, within -1 and 1"""
    previous_action: Floats
    """(N, 2) that of the step before; 0 in the first"""
    collided: Booleans
    off_road: Booleans
    arrived: Booleans

    if not TYPE_CHECKING:  # where it would hide what is no member

        def __getattr__(self, name: str) -> Any:
            later = self.__dict__.get("_later", {})
            if name not in later:
                raise AttributeError(f"a transition has no member `{name}`")
            value = self.__dict__[name] = later[name]()
            return value

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}


def transition_of(
    known: Mapping[str, Any], later: Mapping[str, Callable[[], Floats]]
) -> Transition:
    """One of which some columns are `known`, and the others are what functions give: these must
    not depend on what changes afterward."""
    found = object.__new__(Transition)
    found.__dict__.update(known, _later=later)
    return found
