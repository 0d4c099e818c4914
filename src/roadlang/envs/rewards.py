"""What a reward is made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..geometry.arrays import Booleans, Floats

MOST = 100.0
"""Margins are within this in rewards: an infinite gap to nobody says nothing more."""


@dataclass(frozen=True)
class Transition:
    """What happened to N agents in one step, as columns (N,). SI units and radians."""

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
