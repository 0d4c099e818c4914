"""What is wrong with a place or route in a network that no draw has a say in."""

from __future__ import annotations

import numpy as np

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..geometry.arrays import Floats
from ..geometry.routes.lane_graph import LaneGraph
from ..geometry.routes.nearest_lanes import near_roads
from ..geometry.routes.shortest import LanePlace, PlannedRoute, shortest_route
from ..ir.scenario import ScenarioActor
from .copies import element_of
from .lane_choices import allowed_lanes, lane_choices
from .lane_graphs import lanes_of_network
from .positions import column
from .road_poses import WrittenPlace
from .route_points import FARTHEST, route_points


def route_fault(actor: ScenarioActor, candidates: CandidateBatch) -> Diagnostic | None:
    """RL617 for a point of an agent or object that is far from every lane of its network, RL618 for
    one that no way leads to; None where all is well in the first candidate."""
    network = candidates.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, candidates)
    copies = CopyBatch(candidates, np.zeros(1, np.intp), np.ones(1, np.int64))
    points = _points(actor, copies)
    near = near_roads(lanes, points)
    distances = near.distance.min(axis=0)
    far = np.flatnonzero(distances > FARTHEST)
    if len(far):
        return _far(actor, points[far[0]], float(distances[far[0]]))
    vias = route_points(actor, copies)
    if vias is None:
        return None
    choice = lane_choices(actor, copies, WrittenPlace.of(actor, copies))[0]
    assert choice is not None
    allowed = allowed_lanes(actor, lanes, choice, copies)
    stages = [near.options(lanes, number, lambda _: True) for number in range(len(points))]
    begins = near.options(lanes, 0, allowed.__contains__)
    found = shortest_route(lanes, [begins, *stages[1:]]) if begins else 1
    if isinstance(found, PlannedRoute):
        return None
    return _no_way(actor, points[found], stages, found, lanes)


def _points(actor: ScenarioActor, copies: CopyBatch) -> Floats:
    """(K, 2) the start and the points after it."""
    first = [column(part, copies) for part in evaluate(actor.at, copies, element_of(actor))]
    vias = route_points(actor, copies)
    rest = np.zeros((0, 2)) if vias is None else vias.points[0]
    return np.concatenate([np.stack(first, axis=-1), rest])


def _far(actor: ScenarioActor, point: Floats, distance: float) -> Diagnostic:
    return diagnose(
        Code.FAR_FROM_LANES,
        actor.span,
        x=f"{point[0]:g}m",
        y=f"{point[1]:g}m",
        distance=f"{distance:.3g}m",
        network=actor.on,
        name=actor.name,
        help=f"a point is at most {FARTHEST:g}m from a lane; x counts east, y north, from the "
        "lower left corner of a picture",
    )


def _no_way(
    actor: ScenarioActor,
    point: Floats,
    stages: list[tuple[LanePlace, ...]],
    failed: int,
    lanes: LaneGraph,
) -> Diagnostic:
    said = [f"`{name}`" for name in ("lane", "facing") if name in actor.options]
    leg = stages[failed - 1 : failed + 1]
    if said and isinstance(shortest_route(lanes, stages), PlannedRoute):
        help_ = f"without {' and '.join(said)} there is one"
    elif isinstance(shortest_route(lanes, leg[::-1]), PlannedRoute):
        help_ = "there is one in the other direction only"
    else:
        roads = sorted({lanes.lanes[place.lane].edge for place in leg[0]})
        names = ", ".join(f"`{actor.on}/{road}`" for road in roads)
        help_ = f"see where the lanes of {names} lead to: `emit svg` draws them"
    return diagnose(
        Code.NO_WAY,
        actor.span,
        x=f"{point[0]:g}m",
        y=f"{point[1]:g}m",
        network=actor.on,
        name=actor.name,
        help=help_,
    )
