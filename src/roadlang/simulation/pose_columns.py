"""What follows from the recorded poses of a drive, for simulators that do not report it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.footprints import Footprints, distance_between
from ..ir.scene import Scene, SceneRoad
from ..ir.trace import AgentTrace, Trace
from .lane_columns import LaneSection, on_road
from .stop_lines import StopLines, has_signals
from .world_building import world_of


def with_pose_columns(trace: Trace, scene: Scene) -> Trace:
    """The trace with `road`, `lane`, `lane_offset`, `speed_limit`, `off_road`, `route_progress` and
    `red_light` of agents that follow one road, and `collision` of all.

    An agent that follows no road has no lane: NaN, as for agents with a route.
    """
    roads = {road.name: number for number, road in enumerate(scene.roads)}
    agents = dict(trace.agents)
    stop_lines = world_of([scene], {}, 1.0, 1.0).stop_lines if has_signals(scene) else None
    for row, actor in enumerate(scene.agents):
        agent = agents[actor.name]
        agent = replace(agent, collision=_impacts(agent, trace))
        if actor.road in roads and actor.route is None:
            number = roads[actor.road]
            road, backward = scene.roads[number], actor.facing == "back"
            columns = _on_one_road(agent, road, backward)
            columns["road"] = np.full(len(agent.time), float(number))
            if stop_lines is not None and not stop_lines.is_empty:
                begin = road.length - agent.station[0] if backward else agent.station[0]
                along = begin + columns["route_progress"]
                lap = road.length if road.closed else math.inf
                columns["red_light"] = _red_lights(agent, along, lap, (stop_lines, row))
            changes: dict[str, Any] = dict(columns)
            agent = replace(agent, **changes)
        agents[actor.name] = agent
    return replace(trace, agents=agents)


def _on_one_road(agent: AgentTrace, road: SceneRoad, backward: bool) -> dict[str, Floats]:
    rows = (column[None] for column in (agent.station, agent.x, agent.y, agent.heading))
    on = on_road(road, *rows)
    size = np.array([[agent.length]]), np.array([[agent.width]])
    found = LaneSection.of(road).columns(on, np.array([[backward]]), *size)
    step = np.diff(agent.station, prepend=agent.station[:1])
    if road.closed:  # over the seam the station begins anew
        step = step - np.round(step / road.length) * road.length
    driven = np.cumsum(-step if backward else step)
    zero = np.zeros(len(agent.time))
    columns = {name: values[0] for name, values in found.items()}
    return {**columns, "route_progress": driven, "red_light": zero}


def _red_lights(
    agent: AgentTrace, along: Floats, lap: float, before: tuple[StopLines, int]
) -> Floats:
    """(T,) how many stop lines the front has crossed at red so far. `along`: arc lengths of the
    line; `before`: the stop lines of all agents, and the number of this one."""
    stop_lines, row = before
    count = len(along) - 1
    front, span = along[:-1] + 0.5 * agent.length, (agent.time[:-1], np.diff(agent.time))
    laps, rows = np.full(count, lap), np.full(count, row)
    crossed = stop_lines.crossed_at_red(rows, front, np.diff(along), laps, span)
    return np.concatenate([[0.0], np.cumsum(crossed.astype(np.float64))])


def _impacts(agent: AgentTrace, trace: Trace) -> Floats:
    """(T,) m/s, the hardest impact so far: where `contacts` grows, the speed relative to what is
    nearest then, as it was one sample before."""
    out = np.zeros(len(agent.time))
    for begin in np.flatnonzero(np.diff(agent.contacts, prepend=0.0) > 0.0):
        others = [other for other in trace.agents.values() if other is not agent]
        if not others:
            continue
        apart = [float(_gap(agent, other, int(begin))) for other in others]
        other = others[int(np.argmin(apart))]
        before = max(int(begin) - 1, 0)
        own, its = _velocity(agent, before), _velocity(other, before)
        out[begin:] = np.maximum(out[begin:], np.hypot(own[0] - its[0], own[1] - its[1]))
    return out


def _gap(a: AgentTrace, b: AgentTrace, at: int) -> Floats:
    one, other = (
        Footprints(
            *(np.array(value) for value in (c.x[at], c.y[at], c.heading[at], c.length, c.width))
        )
        for c in (a, b)
    )
    return distance_between(one, other)


def _velocity(agent: AgentTrace, at: int) -> tuple[float, float]:
    heading, speed = float(agent.heading[at]), float(agent.speed[at])
    return speed * float(np.cos(heading)), speed * float(np.sin(heading))
