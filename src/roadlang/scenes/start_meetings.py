"""Agents that come toward each other in bends too narrow for both begin so slowly that one can wait
for the other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from ..geometry.curves.bend_room import BRAKING, LONG, PASSING_GAP, STRAIGHT
from ..ir.scene import SceneRoad
from ..ir.scene_actor import SceneActor
from ..plugins.kinds import STANDING_GAP
from .start_gaps import FARTHEST

COVERED = 0.16
"""Share of the square of its length, times the curvature, that a vehicle covers to each side beyond
its width, in a bend: its front on the outside, its middle on the inside."""


def slowed_before_meetings(
    agents: Sequence[SceneActor], headways: Sequence[float | None], roads: Sequence[SceneRoad]
) -> tuple[SceneActor, ...]:
    """The agents of a scene. Those with a time gap that they keep begin no faster than from where
    they can brake, with `BRAKING`, before the middle between them and one that comes toward them,
    if there is no room for both in the bends of the road between."""
    keep = [headway is not None for headway in headways]
    if not any(keep) or max(agent.length for agent in agents) <= LONG:
        return tuple(agents)
    known = {road.name: road for road in roads}
    groups: dict[str, list[int]] = {}
    for number, agent in enumerate(agents):
        if agent.road in known and agent.start is not None:
            groups.setdefault(agent.road, []).append(number)
    speeds = [agent.start_speed or 0.0 for agent in agents]
    for name, numbers in groups.items():
        road = known[name]
        for pair in combinations(numbers, 2):
            most = _most(agents[pair[0]], agents[pair[1]], road)
            for number in pair:
                if keep[number] and speeds[number] > most:
                    speeds[number] = most
    return tuple(
        agent if speed == (agent.start_speed or 0.0) else replace(agent, start_speed=speed)
        for agent, speed in zip(agents, speeds, strict=True)
    )


def _most(one: SceneActor, other: SceneActor, road: SceneRoad) -> float:
    """m/s at which two on a road may begin, infinite where they do not meet in a narrow bend."""
    aside = abs((one.offset or 0.0) - (other.offset or 0.0))
    spare = aside - 0.5 * (one.width + other.width)
    first, last = sorted((one, other), key=lambda agent: agent.facing == "back")
    between = _start(last) - _start(first)
    if road.closed:
        between %= road.length
    gap = between - 0.5 * (first.length + last.length)
    is_meeting = first.facing != "back" and last.facing == "back" and between >= 0.0
    is_long = max(one.length, other.length) > LONG
    if not (is_meeting and is_long) or spare < 0.0 or gap > FARTHEST:
        return math.inf
    along = np.asarray(road.stations) - (_start(first) - first.length)
    if road.closed:
        along = along % road.length
    seen = (along >= 0.0) & (along <= first.length + between + last.length)
    bend = float(np.abs(np.asarray(road.curvature)[seen]).max(initial=0.0))
    covered = COVERED * bend * (one.length**2 + other.length**2)
    if bend < STRAIGHT or spare > covered + PASSING_GAP:
        return math.inf
    return math.sqrt(2.0 * BRAKING * max(0.0, 0.5 * gap - STANDING_GAP))


def _start(agent: SceneActor) -> float:
    return agent.start or 0.0
