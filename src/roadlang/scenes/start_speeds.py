"""How fast agents are when a drive begins."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields, replace
from typing import cast

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Booleans, Floats
from ..geometry.curves.bend_speeds import square_before, squares_in_bends
from ..ir.batch import RoadBatch
from ..ir.placed_batch import PlacedBatch
from ..ir.scenario import ScenarioActor
from ..ir.scene import Call
from ..ir.scene_actor import SceneActor
from ..ir.surroundings import DEFAULT_SPEED
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import STANDING_GAP, Controller, InitialSpeed
from ..plugins.options import schema_of
from ..plugins.registry import KindEntry, Registry
from ..plugins.results import real_numbers
from ..world.placement.actor_numbers import number_of_copies
from ..world.placement.copies import counts, most_copies
from ..world.placement.placement import placed_routes
from ..world.placement.routes import has_route
from ..world.roads.bends import bends_of_route
from ..world.roads.named_roads import name_of_road, named_lanes, named_road
from ..world.roads.road_places import to_root
from ..world.roads.roads import road_root
from .scene_rows import SceneRows
from .start_gaps import most_behind

STOPS_BEFORE = 1.0
"""Meters before a stop line."""
HEADWAY = 1.0
"""Seconds that who keeps its distance keeps, if its controller has no such option."""


def start_speeds(
    actor: ScenarioActor,
    where: PlacedBatch,
    drives: Sequence[Sequence[tuple[Call, ...]]],
    rows: SceneRows,
) -> list[list[float]]:
    """m/s of each copy of an agent: as the scene file says; else, of agents in a lane, what the
    controller in charge at the start wants, and the bends ahead allow. `drives` has for each scene
    the controllers of each copy, or of all."""
    most = where.x.shape[1]
    if not most:
        return rows.same([])
    written = actor.options.get("start_speed")
    if written is not None:
        return _written_speeds(actor, most, rows)
    if rows.differ(*actor.drive) or not _is_simple(actor, rows.candidates):
        return [
            _speeds_of_one(actor, drives[row], _of_candidate(where, row), rows.alone(row))
            for row in range(rows.count)
        ]
    columns = [
        _wanted_by_all(drives[0][0], actor, where, copy, rows.candidates) for copy in range(most)
    ]
    return [list(row) for row in zip(*columns, strict=True)]


def _written_speeds(actor: ScenarioActor, most: int, rows: SceneRows) -> list[list[float]]:
    candidates = rows.candidates
    copies = CopyBatch.every(candidates, most)
    value = number_of_copies(actor, "start_speed", copies, 0.0)
    present = np.arange(1, most + 1) <= counts(actor, candidates)[:, None]
    copies.record_in(rows.record, present.reshape(-1))
    speeds: list[list[float]] = value.reshape(rows.count, most).tolist()
    return [speeds[row][:count] for row, count in enumerate(present.sum(axis=1).tolist())]


def _speeds_of_one(
    actor: ScenarioActor,
    drives: Sequence[tuple[Call, ...]],
    where: PlacedBatch,
    candidates: CandidateBatch,
) -> list[float]:
    count = most_copies(actor, candidates)
    each = drives if len(drives) == count else [*drives] * count
    in_lane = where.lane[0].tolist()
    return [
        _wanted(calls, actor, where, copy, candidates) if in_lane[copy] else 0.0
        for copy, calls in enumerate(each)
    ]


def _of_candidate(where: PlacedBatch, row: int) -> PlacedBatch:
    """The copies of one candidate: arrays (1, N)."""
    names = (field.name for field in fields(where))
    return PlacedBatch(*(getattr(where, name)[row : row + 1] for name in names))


def _is_simple(actor: ScenarioActor, candidates: CandidateBatch) -> bool:
    """Whether the speeds of an agent in many scenes are found at once: on a declared road."""
    if actor.on is None:
        return True
    is_declared = actor.on in candidates.scenario.roads
    return is_declared and len(named_lanes(actor.on, candidates)) == 1


def _wanted_by_all(
    calls: tuple[Call, ...],
    actor: ScenarioActor,
    where: PlacedBatch,
    copy: int,
    candidates: CandidateBatch,
) -> list[float]:
    """As `_wanted`, of a copy in all candidates."""
    wanted = _initial(calls, candidates)
    in_lane = where.lane[:, copy] != 0
    if wanted is None or actor.on is None or not in_lane.any():
        return [0.0] * candidates.count
    road = named_road(actor.on, candidates)
    start, backward = where.start[:, copy : copy + 1], where.backward[:, copy : copy + 1]
    fastest = _fastest(road, start, backward, wanted.lateral_acceleration, wanted.deceleration)
    speed = wanted.speed
    if speed is None:
        starts, lanes = start[:, 0].tolist(), where.lane[:, copy].tolist()
        limits = [
            wanted.limit_factor * _limit(actor.on, lane, at, candidates, row) if lane else 0.0
            for row, (lane, at) in enumerate(zip(lanes, starts, strict=True))
        ]
    else:
        limits = [float(speed)] * candidates.count
    return [
        min(limit, most) if present else 0.0
        for limit, most, present in zip(limits, fastest, in_lane.tolist(), strict=True)
    ]


def headways_kept(
    actors: Sequence[ScenarioActor], placed: Sequence[SceneActor], scenario: IndexedScenario
) -> list[float | None]:
    """The time gaps, in seconds, of the agents of a scene that keep their distance from the start
    on: whose speed at the start the scene file does not say, and whose first controller keeps it.
    """
    stated = {actor.name for actor in actors if "start_speed" in actor.options}

    def keeps(kind: str) -> bool:
        key = ("keeps distance", kind)
        return scenario.once(key, lambda: _keeps_distance(kind, scenario.registry))

    return [
        _headway(agent.drive[0])
        if agent.drive and agent.group not in stated and keeps(agent.drive[0].kind)
        else None
        for agent in placed
    ]


def _headway(call: Call) -> float:
    return float(call.options.get("headway", HEADWAY))


def _keeps_distance(kind: str, registry: Registry) -> bool:
    return bool(getattr(find_entry(registry, "drive", kind).load(), "keeps_distance", False))


def _initial(calls: tuple[Call, ...], candidates: CandidateBatch) -> InitialSpeed | None:
    """What the first controller wants, unless it waits for something."""
    first = calls[0] if calls and calls[0].when is None and calls[0].during is None else None
    return None if first is None else _initial_speed(first, candidates)


def _wanted(
    calls: tuple[Call, ...],
    actor: ScenarioActor,
    where: PlacedBatch,
    copy: int,
    candidates: CandidateBatch,
) -> float:
    """The speed of a copy of a single candidate."""
    wanted = _initial(calls, candidates)
    if wanted is None:
        return 0.0
    road = str(name_of_road(actor, int(where.road[0, copy])))
    speed, lateral, braking = wanted.speed, wanted.lateral_acceleration, wanted.deceleration
    if speed is None:
        lane, start = int(where.lane[0, copy]), float(where.start[0, copy])
        speed = wanted.limit_factor * _limit(road, lane, start, candidates)
    if has_route(actor, candidates):
        route = placed_routes(actor, candidates)[0, copy]
        ahead, curvature, stop = bends_of_route(route, str(actor.on), candidates)
        most = _slowest(ahead, curvature, lateral, braking)
        if wanted.stops_at_junctions and math.isfinite(stop):
            # As behind somebody who stands there.
            gap = stop - 0.5 * float(where.length[0, copy]) - STOPS_BEFORE + STANDING_GAP
            most = min(most, most_behind(gap, 0.0, _headway(calls[0])))
        return min(float(speed), most)
    only = where.copy(copy + 1)
    line = named_road(road, candidates)
    (fastest,) = _fastest(line, only.start, only.backward, lateral, braking)
    return min(float(speed), fastest)


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
    if wanted is None:
        return None
    speed = None if wanted.speed is None else _number(wanted.speed, "initial speeds", entry)
    if speed is not None and not 0.0 <= speed < math.inf:
        raise wrong_result(entry, None, f"gave the initial speed {speed}")
    lateral = _number(wanted.lateral_acceleration, "lateral accelerations", entry)
    braking = _number(wanted.deceleration, "decelerations", entry)
    factor = _number(wanted.limit_factor, "factors of the speed limit", entry)
    return replace(
        wanted, speed=speed, lateral_acceleration=lateral, deceleration=braking,
        limit_factor=factor,
    )  # fmt: skip


def _number(found: object, what: str, entry: KindEntry) -> float:
    """A part of an initial speed. Raises RL474."""
    numbers = real_numbers(found, what, entry, None)
    if numbers.size != 1:
        fault = f"gave {what} of shape {numbers.shape}, not a number"
        raise wrong_result(entry, None, fault)
    return float(numbers.item())


def _limit(road: str, lane: int, start: float, candidates: CandidateBatch, row: int = 0) -> float:
    """The speed limit of a lane, m/s, in the candidate at a row, or what is usual where there is
    none."""
    ((_, lanes),) = named_lanes(road, candidates)
    limit = lanes.speed_limits.get(lane)
    if limit is None and lane in lanes.pattern.ids:
        limit = lanes.pattern.lane(lane).speed_limit
    if limit is None:
        limit = _zone_limit(road, start, candidates, row)
    if limit is None:
        return DEFAULT_SPEED
    limits = np.ravel(limit)
    return float(limits[min(row, len(limits) - 1)])


def _zone_limit(road: str, start: float, candidates: CandidateBatch, row: int) -> float | None:
    """The speed limit where something starts on a road that is joined of several."""
    changes = road_root(road, candidates).limits if road in candidates.scenario.roads else ()
    if not changes:
        return None
    at = float(to_root(road, candidates, np.array([row]), np.array([start]))[0])
    return [change.speed_limit for change in changes if change.start <= max(at, 0.0)][-1]


def _fastest(
    road: RoadBatch, start: Floats, backward: Booleans, lateral: float, braking: float
) -> list[float]:
    """(V) the greatest speeds from which braking in time suffices for every bend ahead of `start`
    (V, 1)."""
    steps = road.curves.steps
    arc = np.concatenate([np.zeros((len(steps), 1)), np.cumsum(steps, axis=1)], axis=1)
    arc = arc[:, : len(road.stations)]
    ahead = np.where(backward, start - arc, arc - start)
    if road.closed:
        ahead = np.mod(ahead, road.length)
    limits = squares_in_bends(road.curvature, lateral) + 2.0 * braking * ahead
    squares = np.where(ahead >= 0.0, limits, np.inf).min(axis=1, initial=np.inf)
    speeds: list[float] = np.sqrt(squares).tolist()
    return speeds


def _slowest(ahead: Floats, curvature: Floats, lateral: float, braking: float) -> float:
    """Where bends of a curvature (n,) begin `ahead` (n,) meters; those behind do not count."""
    seen = ahead >= 0.0
    limits = squares_in_bends(curvature[seen], lateral)
    return math.sqrt(square_before(limits, ahead[seen], braking))
