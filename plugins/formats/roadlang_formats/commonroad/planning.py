"""The planning problem of CommonRoad: from where the ego starts to where it should be."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from roadlang.geometry import Floats
from roadlang_formats.lanelets.model import LaneletMap, xy

from .elements import put, put_exact, put_point, put_rectangle
from .obstacles import ego_of

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, Trace

    from .numbering import Numbering

_LONGEST = 60.0
"""Seconds to reach the goal, where the scene has no duration."""
_GOAL = 10.0, 3.0
"""Length and width of the goal of a drive, meters."""
_BEFORE_END = 1.0
"""Meters before the end of a road, where the goal of who follows it lies."""


def put_planning_problem(
    root: Element,
    scene: Scene,
    trace: Trace | None,
    lanelets: LaneletMap,
    ids: Mapping[int, int],
    numbering: Numbering,
    step: float,
) -> None:
    """One: for the ego; without agents, along the first lanelet, preferably for vehicles. None
    where there is no lanelet."""
    ego = ego_of(scene)
    drivable = [number for number in ids if lanelets.lanelets[number].drivable]
    candidates = drivable or list(ids)
    if not candidates:
        return
    problem = put(root, "planningProblem", id=numbering.next())
    if ego is None:
        middle = _middle(lanelets, candidates[0])
        dx, dy = middle[1] - middle[0]
        x, y = middle[:2].mean(axis=0).tolist()
        start, speed = (x, y, math.atan2(dy, dx)), 0.0
    else:
        start, speed = (ego.x, ego.y, ego.heading), ego.start_speed or 0.0
    _put_start(problem, start, speed)
    goal = put(problem, "goalState")
    agent = trace.agents.get(ego.name) if trace is not None and ego is not None else None
    if agent is not None:
        last = max(1, agent.samples_there - 1)
        at = min(last, len(agent.time) - 1)
        pose = float(agent.heading[at]), float(agent.x[at]), float(agent.y[at])
        _put_time(goal, last)
        put_rectangle(put(goal, "position"), *_GOAL, math.remainder(pose[0], math.tau), *pose[1:])
        return
    duration = (
        float(scene.simulate.options.get("duration", _LONGEST)) if scene.simulate else _LONGEST
    )
    _put_time(goal, max(1, round(duration / step)))
    target = candidates[0] if ego is None else _goal(scene, ego, lanelets, candidates)
    put(put(goal, "position"), "lanelet", ref=ids[target])


def _put_start(parent: Element, pose: tuple[float, float, float], speed: float) -> None:
    state = put(parent, "initialState")
    put_point(put(state, "position"), pose[0], pose[1])
    put_exact(state, "orientation", math.remainder(pose[2], math.tau))
    put_exact(state, "time", 0)
    put_exact(state, "velocity", float(speed))
    put_exact(state, "yawRate", 0.0)
    put_exact(state, "slipAngle", 0.0)


def _put_time(parent: Element, last: int) -> None:
    time = put(parent, "time")
    put(time, "intervalStart", 0)
    put(time, "intervalEnd", last)


def _goal(scene: Scene, ego: SceneActor, lanelets: LaneletMap, candidates: list[int]) -> int:
    """The lanelet at the end of its route, or of its road."""
    name, lane, station, forward = _end_of_way(scene, ego)
    road = next((road for road in scene.roads if road.name == name), None)
    if road is None:
        return _nearest(lanelets, candidates, np.array([ego.x, ego.y]), ego.heading)
    x, y, heading = (
        float(np.interp(station, road.stations, values))
        for values in (road.x, road.y, road.heading)
    )
    section = road.cross_section()
    away = float(section.offset(lane, station)) if lane in section.ids else ego.offset or 0.0
    point = np.array([x - away * math.sin(heading), y + away * math.cos(heading)])
    return _nearest(lanelets, candidates, point, heading if forward else heading + math.pi)


def _end_of_way(scene: Scene, ego: SceneActor) -> tuple[str, int, float, bool]:
    """Road, lane, station, and whether it is reached in the direction of the road."""
    if ego.route is not None:
        step = ego.route.steps[-1]
        return step.road, step.lane, step.stop, step.stop >= step.start
    road = next((road for road in scene.roads if road.name == ego.road), None)
    if road is None:
        return "", 0, 0.0, True
    forward = ego.facing == "forward"
    before, after = road.trim
    ends = before + _BEFORE_END, road.length - after - _BEFORE_END
    return road.name, ego.lane or 0, ends[1] if forward else ends[0], forward


def _nearest(lanelets: LaneletMap, candidates: list[int], point: Floats, heading: float) -> int:
    """The lanelet nearest to a point of those that run about that way."""
    direction = np.array([math.cos(heading), math.sin(heading)])

    def away(number: int) -> float:
        middle = _middle(lanelets, number)
        begin, chord = middle[:-1], np.diff(middle, axis=0)
        length = np.maximum((chord**2).sum(axis=1), 1e-12)
        share = np.clip(((point - begin) * chord).sum(axis=1) / length, 0.0, 1.0)
        distance = np.hypot(*(begin + share[:, None] * chord - point).T)
        return float(np.where(chord @ direction > 0.0, distance, np.inf).min())

    return min(candidates, key=lambda number: (away(number), number))


def _middle(lanelets: LaneletMap, number: int) -> Floats:
    lanelet = lanelets.lanelets[number]
    left, right = (xy(lanelets.line(side)) for side in (lanelet.left, lanelet.right))
    return (left + right) / 2.0
