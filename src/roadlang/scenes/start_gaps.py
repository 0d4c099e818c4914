"""Agents that keep their distance begin so slowly that they have it, behind who is ahead."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from ..ir.scene import SceneNetwork, SceneRoad
from ..ir.scene_actor import SceneActor
from ..plugins.kinds import STANDING_GAP

SHORTER = 1.2
"""The gap that a driver wants over that which an agent may begin with: who follows by the
intelligent driver model brakes with about 1 m/s^2 then, and so do those behind."""
APPROACH = 5.6
"""m/s^2: by how much over this the speed of an agent times what it is faster is more gap wanted: as
in the intelligent driver model, twice the root of usual acceleration and comfortable braking."""
FARTHEST = 150.0
"""Meters ahead that decide how fast an agent may begin."""
BESIDE = 0.2
"""Meters to each side between two that pass each other."""


@dataclass(frozen=True)
class _Leader:
    """Who is ahead of an agent: its number, or that of an object after those of all agents."""

    number: int
    gap: float
    """meters from bumper to bumper, at least 0"""
    same_direction: bool


def slowed_behind(
    agents: Sequence[SceneActor],
    objects: Sequence[SceneActor],
    headways: Sequence[float | None],
    networks: Sequence[SceneNetwork],
    roads: Sequence[SceneRoad],
) -> tuple[SceneActor, ...]:
    """The agents of a scene. Those with a time gap that they keep, seconds, begin no faster than
    they would soon be behind everything ahead in their lanes, so that nobody brakes hard."""
    if not any(headway is not None for headway in headways):
        return tuple(agents)
    actors = (*agents, *objects)
    places: dict[str, list[int]] = {}
    for number, actor in enumerate(actors):
        if actor.road is not None and actor.start is not None:
            places.setdefault(actor.road, []).append(number)
    turns = _turn_lengths(networks) if any(a.route is not None for a in agents) else {}
    laps = {road.name: road.length for road in roads if road.closed}
    ahead = {
        number: list(_leaders(number, actors, places, turns, laps))
        for number, agent in enumerate(agents)
        if headways[number] is not None and (agent.start_speed or 0.0) > 0.0
    }
    speeds = [actor.start_speed or 0.0 for actor in actors]
    changed = True
    while changed:
        changed = False
        for number, leaders in ahead.items():
            headway = headways[number] or 0.0
            most = min(
                (
                    most_behind(one.gap, speeds[one.number] if one.same_direction else 0.0, headway)
                    for one in leaders
                ),
                default=math.inf,
            )
            if most < speeds[number]:
                speeds[number], changed = most, True
    return tuple(
        replace(agent, start_speed=speeds[number]) if number in ahead else agent
        for number, agent in enumerate(agents)
    )


def most_behind(gap: float, ahead: float, headway: float) -> float:
    """m/s at which the gap that a driver wants is `SHORTER` times the one that there is: the root
    of `v^2 / APPROACH + (headway - u / APPROACH) v = rest`, behind one that drives at `u`."""
    rest = max(0.0, SHORTER * gap - STANDING_GAP)
    slope = headway - ahead / APPROACH
    return 0.5 * APPROACH * (math.sqrt(slope * slope + 4.0 * rest / APPROACH) - slope)


def _leaders(
    number: int,
    actors: Sequence[SceneActor],
    places: Mapping[str, Sequence[int]],
    turns: Mapping[tuple[str, int, int], float],
    laps: Mapping[str, float],
) -> Iterator[_Leader]:
    """Everything ahead in the lanes of an agent, as far as it matters. `laps`: the lengths of
    closed roads, whose start follows their end."""
    agent = actors[number]
    for road, lane, begin, sign, before in _road_ahead(agent, turns):
        for other in places.get(road, ()):
            other_actor = actors[other]
            assert other_actor.start is not None
            distance = before + sign * (other_actor.start - begin)
            if road in laps:
                distance %= laps[road]
            gap = distance - 0.5 * (agent.length + other_actor.length)
            if other == number or distance <= 0.0 or gap > FARTHEST:
                continue
            first = before == 0.0
            if _in_lane(agent, other_actor) if first else other_actor.lane == lane:
                same = (other_actor.facing == "back") == (sign < 0.0)
                yield _Leader(other, max(0.0, gap), same)


def _in_lane(agent: SceneActor, other: SceneActor) -> bool:
    """Whether something on the road of an agent is in its way, where the agent is now."""
    aside = abs((other.offset or 0.0) - (agent.offset or 0.0))
    return aside < 0.5 * (agent.width + other.width) + BESIDE


def _road_ahead(
    agent: SceneActor, turns: Mapping[tuple[str, int, int], float]
) -> Iterator[tuple[str, int, float, float, float]]:
    """The roads ahead of an agent: name, lane, the station at which it comes there and in which
    direction (1 or -1), and how far that is."""
    if agent.road is None or agent.start is None:
        return
    sign = -1.0 if agent.facing == "back" else 1.0
    if agent.route is None:
        yield agent.road, agent.lane or 0, agent.start, sign, 0.0
        return
    before = 0.0
    for number, step in enumerate(agent.route.steps):
        if before > FARTHEST:
            return
        begin = step.start if number else agent.start
        sign = 1.0 if step.stop >= step.start else -1.0
        yield step.road, step.lane, begin, sign, before
        before += abs(step.stop - begin)
        if step.turn is not None:
            before += turns.get((step.turn.network, step.turn.junction, step.turn.connection), 0.0)


def _turn_lengths(networks: Sequence[SceneNetwork]) -> dict[tuple[str, int, int], float]:
    return {
        (network.name, junction.id, connection.id): connection.length
        for network in networks
        for junction in network.junctions
        for connection in junction.connections
    }
