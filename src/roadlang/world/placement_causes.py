"""Why an agent or object found no place in a candidate that its lane or its route decides."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..diagnostics import Diagnostic
from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..geometry.routes.legs import PlannedRoute, RoutePlace
from ..geometry.routes.shortest import shortest_route
from ..ir.scenario import ScenarioActor
from .lane_choices import allowed_lanes, lane_choices
from .lane_graphs import lanes_of_network
from .named_roads import named_lanes
from .placement import missing_lane, room_among_others
from .placement_faults import unknown_lane
from .positions import names_another
from .road_poses import WrittenPlace
from .route_points import TurnWords, route_points


def lane_fault(actor: ScenarioActor, candidates: CandidateBatch) -> Diagnostic | None:
    """RL613 for the lane of a copy in the first candidate, which another decides; None where its
    road has that lane."""
    found = missing_lane(actor, candidates)
    if found is None:
        return None
    road, lane = found
    known = {id for _, lanes in named_lanes(road, candidates) for id in lanes.pattern.ids}
    span = actor.span_of("lane" if "lane" in actor.options else "at")
    return unknown_lane(actor, lane, tuple(sorted(known, reverse=True)), span)


def cause_of_place(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """What an agent or object lacks in the first candidate besides room, in words."""
    found = missing_lane(actor, candidates)
    if found is not None:
        return f"`{found[0]}` has no lane {found[1]} for `{actor.name}`"
    if actor.on not in candidates.scenario.networks or "route" not in actor.options:
        return None
    return _without_turns(actor, candidates)


def beyond_road(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """That what nothing is in the way of does not fit on its road, or beside it."""
    if actor.on is None or actor.on in candidates.scenario.networks:
        return None
    if actor.is_beside_road:
        return f"`{actor.name}` would stand in a driving lane, or beyond the ends of `{actor.on}`"
    missing = -float(room_among_others(actor, candidates)[0])
    return f"`{actor.name}` would stand {missing:.3g}m beyond the end of `{actor.on}`"


def _without_turns(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """That the turns of a route can be made from nowhere in its network."""
    network = candidates.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, candidates)
    copies = CopyBatch(candidates, np.zeros(1, np.intp), np.ones(1, np.int64))
    route = route_points(actor, copies, lanes)
    parts: tuple[Any, ...] = () if route is None else route.parts
    words = [part.word(0) for part in parts if isinstance(part, TurnWords)]
    choice = lane_choices(actor, copies, WrittenPlace.of(actor, copies), lanes)[0]
    by_another = names_another(actor, candidates.scenario)
    if route is None or len(words) < len(parts) or choice is None or by_another:
        return None
    allowed = sorted(allowed_lanes(actor, lanes, choice, copies))
    begins = tuple(RoutePlace(lane, lanes.begin[lane]) for lane in allowed)
    if isinstance(shortest_route(lanes, begins, route.stages(0)), PlannedRoute):
        return None
    turns = ", then ".join(f"`{word}`" for word in words)
    return f"from no lane of `{actor.on}` can `{actor.name}` go {turns} at its next junctions"
