"""What a drive was like: its road, its behavior, the moment that decided it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from ..geometry.areas.rings import outside_ring
from ..geometry.arrays import Floats
from ..ir.scene import Scene, SceneActor, SceneRoad, Verdict
from ..ir.scene_road import numbers_of
from ..ir.trace import AgentTrace, Trace
from ..judging.deciding_moment import first_violation
from ..plugins.kinds import ROAD_PLACES
from ..plugins.registry import Registry
from .least_gap import least_gap
from .outcome import Moment

CURVATURE = 0.008
"""Root mean square difference of curvature beyond which roads are distinct, 1/m."""
SPEED, STATION = 10.0, 100.0
"""Differences beyond which the behavior at the deciding moment is distinct, m/s and meters."""
_DECIMALS = 6
_PARTS = np.arange(ROAD_PLACES, dtype=np.float64)


def moment_of(verdict: Verdict, scene: Scene, trace: Trace, registry: Registry) -> Moment | None:
    """When, where and for whom a drive that violates an expectation goes wrong."""
    found = first_violation(verdict, trace, registry)
    if found is None or not found.actors:
        return None
    sample = found.sample
    agent = found.actors[0]
    partner = found.actors[1] if len(found.actors) > 1 else None
    kinds = {actor.name: actor.kind for actor in (*scene.agents, *scene.objects)}
    return Moment(
        verdict.name,
        float(trace.time[sample]),
        agent.name,
        float(agent.x[sample]),
        float(agent.y[sample]),
        _finite(agent.station[sample]),
        _finite(agent.speed[sample]),
        "" if partner is None else partner.name,
        "" if partner is None else kinds.get(partner.name, ""),
        None if partner is None else _closing(agent, partner, sample),
        _place(scene, agent, sample),
    )


def descriptor(scene: Scene, trace: Trace, name: str, moment: Moment | None) -> tuple[float, ...]:
    """The curvature of the road of agent `name` at equal parts of its length, then its speed, the
    station and the closing speed at the moment, each in differences that count."""
    road = road_of(scene, name)
    curvature = np.zeros(ROAD_PLACES)
    if road is not None:
        stations = numbers_of(road, "stations")
        end = stations[-1]
        places = _PARTS * (end / _PARTS[-1])  # `linspace` is slow
        places[-1] = end
        curvature = np.interp(places, stations, numbers_of(road, "curvature"))
    agent = trace.agents.get(name)
    speed = station = closing = 0.0
    if moment is None:
        speed = 0.0 if agent is None or not len(trace.time) else _mean(agent.speed)
    else:
        speed, station = moment.speed or 0.0, moment.station or 0.0
        closing = moment.closing or 0.0
    behavior = [speed / SPEED, station / STATION, closing / SPEED]
    vector = np.concatenate([curvature / (CURVATURE * math.sqrt(ROAD_PLACES)), behavior])
    if not np.isfinite(vector).all():
        vector = np.nan_to_num(vector)
    return tuple(np.round(vector, _DECIMALS).tolist())


def measures(scene: Scene, trace: Trace, name: str) -> dict[str, float | None]:
    """What coverage counts: greatest curvature and speed of an agent, its least gap to others."""
    road, agent = road_of(scene, name), trace.agents.get(name)
    found: dict[str, float | None] = {"curvature": None, "speed": None, "gap": None}
    if road is not None:
        found["curvature"] = float(np.abs(numbers_of(road, "curvature")).max())
    if agent is not None and len(trace.time):
        found["speed"] = _finite(agent.speed.max())
        others = [other for other in trace.agents.values() if other is not agent]
        found["gap"] = _finite(least_gap(agent, others))
    return found


def protagonist(scene: Scene, names: Sequence[str]) -> str:
    """The agent that the first of the expectations is about, else the first of the scene."""
    agents = {agent.group: agent for agent in reversed(scene.agents)}
    agents |= {agent.name: agent for agent in scene.agents}
    verdicts = {verdict.name: verdict for verdict in scene.expectations}
    for name in names:
        for mentioned in _mentioned(verdicts[name]):
            if mentioned in agents:
                return agents[mentioned].name
    return scene.agents[0].name if scene.agents else ""


def road_of(scene: Scene, name: str) -> SceneRoad | None:
    """The road of an agent; without one the first that is driven."""
    actor: SceneActor | None = next((a for a in scene.agents if a.name == name), None)
    roads = {road.name: road for road in scene.roads}
    if actor is not None and actor.road in roads:
        return roads[actor.road]
    return next((road for road in scene.roads if road.derived), None)


def _place(scene: Scene, agent: AgentTrace, sample: int) -> str:
    """The road or junction of a network in which an agent is."""
    if not scene.networks:
        return ""
    number = float(agent.road[sample])
    if number >= 0.0:
        road = scene.roads[int(number)]
        return road.name if road.network else ""
    if math.isnan(number):
        return ""
    at = agent.x[sample : sample + 1], agent.y[sample : sample + 1]
    near = [
        (
            float(outside_ring(np.array(junction.area), *at)[0]),
            f"junction {junction.id} of {network.name}",
        )
        for network in scene.networks
        for junction in network.junctions
        if junction.area
    ]
    return min(near, default=(0.0, ""))[1]


def _mentioned(verdict: Verdict) -> list[str]:
    formula: Mapping[str, object] = verdict.formula or {}
    signals = formula.get("signals", {})
    assert isinstance(signals, Mapping)
    calls = [*signals.values(), formula]
    return [
        value
        for call in calls
        for value in call.get("options", {}).values()
        if isinstance(value, str)
    ]


def _closing(agent: AgentTrace, partner: AgentTrace, sample: int) -> float | None:
    """The speed with which the distance of two gets less."""
    last = min(sample + 1, len(agent.time) - 1)
    first = max(last - 1, 0)
    if first == last:
        return None
    ends = [
        math.hypot(float(agent.x[at] - partner.x[at]), float(agent.y[at] - partner.y[at]))
        for at in (first, last)
    ]
    return _finite((ends[0] - ends[1]) / float(agent.time[last] - agent.time[first]))


def _mean(values: Floats) -> float:
    """Of those that are numbers."""
    return float(np.nanmean(values) if np.isnan(values).any() else values.mean())


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
