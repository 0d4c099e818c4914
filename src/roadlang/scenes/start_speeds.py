"""How fast agents are when a drive begins."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import cast

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..geometry.arrays import Floats
from ..geometry.bend_speeds import square_before, squares_in_bends
from ..ir.placed_batch import PlacedBatch
from ..ir.scenario import ScenarioActor
from ..ir.scene import Call
from ..ir.scene_actor import SceneActor
from ..ir.surroundings import DEFAULT_SPEED
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Controller, InitialSpeed
from ..plugins.options import schema_of
from ..world.bends import bends_of_route
from ..world.copies import element_of
from ..world.named_roads import name_of_road, named_lanes, named_road
from ..world.placement import placed_routes
from ..world.road_places import to_root
from ..world.roads import road_root
from ..world.routes import has_route

STOPS_BEFORE = 1.0
"""Meters before a stop line."""


def start_speeds(
    actor: ScenarioActor,
    where: PlacedBatch,
    drives: list[tuple[Call, ...]],
    candidates: CandidateBatch,
) -> list[float]:
    """m/s of each copy of an agent of a single candidate: as the scene file says; else, of agents
    in a lane, what the controller in charge at the start wants, and the bends ahead allow."""
    count = where.x.shape[1]
    if not count:
        return []
    written = actor.options.get("start_speed")
    if written is not None:
        copies = CopyBatch.every(candidates, count)
        value = np.asarray(evaluate(written, copies, element_of(actor)), float).reshape(-1)
        if candidates.record is not None:
            copies.record_in(candidates.record)
        return list(np.broadcast_to(value, (count,)).tolist())
    each = drives if len(drives) == count else drives * count
    in_lane = where.lane[0].tolist()
    return [
        _wanted(calls, actor, where, copy, candidates) if in_lane[copy] else 0.0
        for copy, calls in enumerate(each)
    ]


def keep_distance(
    actors: Sequence[ScenarioActor], placed: Sequence[SceneActor], candidates: CandidateBatch
) -> list[bool]:
    """Which of the agents of a candidate keep their distance from the start on: whose speed at the
    start the scene file does not say, and whose first controller does that."""
    stated = {actor.name for actor in actors if "start_speed" in actor.options}
    registry = candidates.scenario.registry
    known: dict[str, bool] = {}

    def keeps(kind: str) -> bool:
        if kind not in known:
            loaded = find_entry(registry, "drive", kind).load()
            known[kind] = bool(getattr(loaded, "keeps_distance", False))
        return known[kind]

    return [
        bool(agent.drive) and agent.group not in stated and keeps(agent.drive[0].kind)
        for agent in placed
    ]


def _wanted(
    calls: tuple[Call, ...],
    actor: ScenarioActor,
    where: PlacedBatch,
    copy: int,
    candidates: CandidateBatch,
) -> float:
    """What the first controller wants, unless it waits for something."""
    first = calls[0] if calls and calls[0].when is None and calls[0].during is None else None
    wanted = _initial_speed(first, candidates) if first is not None else None
    if wanted is None:
        return 0.0
    road = str(name_of_road(actor, int(where.road[0, copy])))
    speed, lateral, braking = wanted.speed, wanted.lateral_acceleration, wanted.deceleration
    if speed is None:
        lane, start = int(where.lane[0, copy]), float(where.start[0, copy])
        speed = _limit(road, lane, start, candidates)
    if has_route(actor, candidates):
        route = placed_routes(actor, candidates)[0, copy]
        stops = wanted.stops_at_junctions
        front = 0.5 * float(where.length[0, copy]) + STOPS_BEFORE if stops else None
        ahead, curvature = bends_of_route(route, str(actor.on), candidates, front=front)
        return min(float(speed), _slowest(ahead, curvature, lateral, braking))
    start, backward = float(where.start[0, copy]), bool(where.backward[0, copy])
    return min(float(speed), _fastest(road, start, backward, lateral, braking, candidates))


def _initial_speed(call: Call, candidates: CandidateBatch) -> InitialSpeed | None:
    """What a controller says."""
    registry = candidates.scenario.registry
    if not registry.has("drive", call.kind):
        return None
    entry = find_entry(registry, "drive", call.kind)
    with plugin_guard(entry, None):
        kind = entry.load()
        names = {option.name for option in schema_of(kind)}
        options = {key: value for key, value in call.options.items() if key in names}
        wanted = cast("Controller", kind(**options)).initial_speed()
    if wanted is not None and not isinstance(wanted, InitialSpeed):
        fault = f"gave {type(wanted).__name__} for `initial_speed`, not an InitialSpeed"
        raise wrong_result(entry, None, fault)
    if wanted is not None and not 0.0 <= float(wanted.speed or 0.0) < math.inf:
        raise wrong_result(entry, None, f"gave the initial speed {wanted.speed}")
    return wanted


def _limit(road: str, lane: int, start: float, candidates: CandidateBatch) -> float:
    """The speed limit of a lane, m/s, or what is usual where there is none."""
    ((_, lanes),) = named_lanes(road, candidates)
    limit = lanes.speed_limits.get(lane)
    if limit is None and lane in lanes.pattern.ids:
        limit = lanes.pattern.lane(lane).speed_limit
    if limit is None:
        limit = _zone_limit(road, start, candidates)
    return DEFAULT_SPEED if limit is None else float(np.ravel(limit)[0])


def _zone_limit(road: str, start: float, candidates: CandidateBatch) -> float | None:
    """The speed limit where something starts on a road that is joined of several."""
    changes = road_root(road, candidates).limits if road in candidates.scenario.roads else ()
    if not changes:
        return None
    at = float(to_root(road, candidates, np.zeros(1, np.intp), np.array([start]))[0])
    return [change.speed_limit for change in changes if change.start <= max(at, 0.0)][-1]


def _fastest(
    name: str,
    start: float,
    backward: bool,
    lateral: float,
    braking: float,
    candidates: CandidateBatch,
) -> float:
    """The greatest speed from which braking in time suffices for every bend ahead of `start`."""
    road = named_road(name, candidates)
    arc = np.concatenate([[0.0], np.cumsum(road.curves.steps[0])])[: len(road.stations)]
    ahead = start - arc if backward else arc - start
    if road.closed:
        ahead = np.mod(ahead, float(road.length[0, 0]))
    return _slowest(ahead, road.curvature[0], lateral, braking)


def _slowest(ahead: Floats, curvature: Floats, lateral: float, braking: float) -> float:
    """Where bends of a curvature (n,) begin `ahead` (n,) meters; those behind do not count."""
    seen = ahead >= 0.0
    limits = squares_in_bends(curvature[seen], lateral)
    return math.sqrt(square_before(limits, ahead[seen], braking))
