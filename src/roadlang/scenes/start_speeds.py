"""How fast agents are when a drive begins."""

from __future__ import annotations

import math
from collections.abc import Sequence

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
from ..ir.surroundings import USUAL_SPEED
from ..plugins.finding import find_entry
from ..world.bends import bends_of_route
from ..world.copies import element_of
from ..world.named_roads import name_of_road, named_lanes, named_road
from ..world.placement import placed_routes
from ..world.routes import has_route

STOPS_BEFORE = 1.0
"""Meters before a stop line."""
CALM_LATERAL, CALM_BRAKING = 3.0, 3.0
"""m/s^2: of controllers that do not say with what they take bends, on a route. They may obey right
of way: they begin so slowly that they can stop where the next junction begins."""


def start_speeds(
    actor: ScenarioActor,
    where: PlacedBatch,
    drives: list[tuple[Call, ...]],
    candidates: CandidateBatch,
) -> list[float]:
    """m/s of each copy of an agent of a single candidate: as the scene file says; else, of agents
    in a lane, what the controller in charge at the start wants, and the bends ahead allow."""
    count = where.x.shape[1]
    said = actor.options.get("start_speed")
    if said is not None:
        copies = CopyBatch.every(candidates, count)
        value = np.asarray(evaluate(said, copies, element_of(actor)), float).reshape(-1)
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
    said = {actor.name for actor in actors if "start_speed" in actor.options}
    registry = candidates.scenario.registry
    known: dict[str, bool] = {}

    def keeps(kind: str) -> bool:
        if kind not in known:
            loaded = find_entry(registry, "drive", kind).load()
            known[kind] = bool(getattr(loaded, "keeps_distance", False))
        return known[kind]

    return [
        bool(agent.drive) and agent.group not in said and keeps(agent.drive[0].kind)
        for agent in placed
    ]


def _wanted(
    calls: tuple[Call, ...],
    actor: ScenarioActor,
    where: PlacedBatch,
    copy: int,
    candidates: CandidateBatch,
) -> float:
    """What the first controller wants, unless it waits for something: by its options `speed` and,
    before bends, `lateral_acceleration` and `deceleration`, as far as the kind has them."""
    first = calls[0] if calls and calls[0].when is None and calls[0].during is None else None
    if first is None or "speed" not in first.options:
        return 0.0
    road = str(name_of_road(actor, int(where.road[0, copy])))
    speed = first.options["speed"]
    if speed is None:  # a controller that goes by the speed limit
        speed = _limit(road, int(where.lane[0, copy]), candidates)
    if not isinstance(speed, int | float):
        return 0.0
    lateral, braking = (first.options.get(k) for k in ("lateral_acceleration", "deceleration"))
    plain = not isinstance(lateral, int | float) or not isinstance(braking, int | float)
    if plain and not has_route(actor, candidates):
        return float(speed)
    if not isinstance(lateral, int | float) or not isinstance(braking, int | float):
        lateral, braking = CALM_LATERAL, CALM_BRAKING
    start, backward = float(where.start[0, copy]), bool(where.backward[0, copy])
    limit = _fastest(road, start, backward, float(lateral), float(braking), candidates)
    if has_route(actor, candidates):
        route = placed_routes(actor, candidates)[0, copy]
        front = 0.5 * float(where.length[0, copy]) + STOPS_BEFORE if plain else None
        ahead, curvature = bends_of_route(route, str(actor.on), candidates, front=front)
        limit = _slowest(ahead, curvature, float(lateral), float(braking))
    return min(float(speed), limit)


def _limit(road: str, lane: int, candidates: CandidateBatch) -> float:
    """The speed limit of a lane, m/s, or what is usual where there is none."""
    ((_, lanes),) = named_lanes(road, candidates)
    limit = lanes.speed_limits.get(lane)
    if limit is None and lane in lanes.pattern.ids:
        limit = lanes.pattern.lane(lane).speed_limit
    return USUAL_SPEED if limit is None else float(np.ravel(limit)[0])


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
