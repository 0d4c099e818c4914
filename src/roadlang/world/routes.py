"""The routes of placed agents through their network."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..geometry.routes.lane_graph import LaneGraph, TravelLane
from ..geometry.routes.shortest import LanePlace, PlannedRoute, shortest_route
from ..geometry.routes.wandering import random_route
from ..ir.scenario import ScenarioActor
from .copies import element_of
from .lane_graphs import lanes_of_network
from .placement import placed
from .positions import column
from .road_places import to_root
from .route_points import route_points

USUAL_LENGTH = 2_000.0
"""Meters of a random route whose length is not said"""


def routes_of(actor: ScenarioActor, candidates: CandidateBatch) -> NDArray[Any]:
    """(V, N) the `PlannedRoute` of every copy of an agent, by arc lengths of the roots of its
    roads; None of a copy without route."""
    make = candidates.once
    return make(("routes", actor.name), lambda: _routes(actor, candidates), inherited=False)


def _routes(actor: ScenarioActor, candidates: CandidateBatch) -> NDArray[Any]:
    where = placed(actor, candidates)
    found = np.full(where.x.shape, None, dtype=object)
    if "route" not in actor.options or where.x.size == 0:
        return found
    network = candidates.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, candidates)
    copies = CopyBatch.every(candidates, where.x.shape[1])
    starts = _starts(actor, candidates, lanes, copies)
    points = route_points(actor, copies)
    numbers = None if points is not None else _number(actor, "route", copies, 0.0)
    lengths = _number(actor, "route_length", copies, USUAL_LENGTH)
    if candidates.record is not None:
        copies.record_in(candidates.record)
    present = where.present.reshape(-1)
    for row in np.flatnonzero(present).tolist():
        start, route = starts[row], None
        if start is not None and points is not None:
            stages = [(start,), *points.stages(lanes, row)]
            planned = shortest_route(lanes, stages)
            route = planned if isinstance(planned, PlannedRoute) else None
        elif start is not None and numbers is not None:
            route = random_route(lanes, start, float(lengths[row]), float(numbers[row]))
        found.reshape(-1)[row] = route
    return found


def _starts(
    actor: ScenarioActor, candidates: CandidateBatch, lanes: LaneGraph, copies: CopyBatch
) -> list[LanePlace | None]:
    """(R) where copies stand, by arc length of the root; None of one in no lane."""
    where = placed(actor, candidates)
    road, lane, backward = (
        getattr(where, name).reshape(-1).tolist() for name in ("road", "lane", "backward")
    )
    start, station = where.start.reshape(-1), np.zeros(copies.count)
    for edge in set(road):
        chosen = np.flatnonzero(np.array(road) == edge)
        name, rows = f"{actor.on}/{edge}", copies.rows[chosen]
        station[chosen] = to_root(name, candidates, rows, start[chosen])
    numbers = {lane: number for number, lane in enumerate(lanes.lanes)}
    keys = (TravelLane(*parts) for parts in zip(road, lane, backward, strict=True))
    return [
        LanePlace(numbers[key], float(station[row])) if key in numbers else None
        for row, key in enumerate(keys)
    ]


def _number(actor: ScenarioActor, name: str, copies: CopyBatch, usual: float) -> Any:
    value = actor.options.get(name)
    if value is None:
        return np.full(copies.count, usual)
    return column(evaluate(value, copies, element_of(actor)), copies)
