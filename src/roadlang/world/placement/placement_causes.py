"""Why an agent or object found no place in a candidate that its lane or its route decides."""

from __future__ import annotations

import numpy as np

from ...diagnostics import Diagnostic
from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...ir.scenario import ScenarioActor
from ..networks.lane_graphs import lanes_of_network
from ..placement_faults import beyond_the_end, unknown_lane
from ..roads.named_roads import named_lanes
from .begins_with_turns import leads_on
from .lane_choices import allowed_lanes, lane_choices
from .placement import missing_lane, room_among_others, why_no_place
from .positions import named_other, names_another
from .road_poses import WrittenPlace
from .route_points import TurnWords, route_points
from .spots import NoPlace


def lane_fault(actor: ScenarioActor, candidates: CandidateBatch) -> Diagnostic | None:
    """RL613 for the lane of a copy in the first candidate, which another decides; None where its
    road has that lane."""
    found = missing_lane(actor, candidates)
    if found is None:
        return None
    road, lane = found
    known = {id for _, lanes in named_lanes(road, candidates) for id in lanes.pattern.ids}
    return unknown_lane(actor, lane, tuple(sorted(known, reverse=True)))


def cause_of_place(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """What an agent or object lacks in the first candidate besides room, in words."""
    found = missing_lane(actor, candidates)
    if found is not None:
        return f"`{found[0]}` has no lane {found[1]} for `{actor.name}`"
    if why_no_place(actor, candidates) == NoPlace.NO_OTHER:
        other = named_other(actor, candidates.scenario)
        return f"`{actor.name}` is placed relative to `{other}`, which does not exist in this scene"
    if actor.on not in candidates.scenario.networks or "route" not in actor.options:
        return None
    return _without_turns(actor, candidates) or _without_way(actor, candidates)


def _without_way(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """That no way leads through the points of a route from where another decides it to begin."""
    if not names_another(actor, candidates.scenario):
        return None
    if why_no_place(actor, candidates) != NoPlace.NO_WAY:
        return None
    return f"no path in `{actor.on}` follows the `route` of `{actor.name}` from where it starts"


def beyond_road(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """That what nothing is in the way of does not fit on its road, or beside it."""
    if actor.on is None or why_no_place(actor, candidates) != NoPlace.HAS_ONE:
        return None
    missing = -float(room_among_others(actor, candidates)[0])
    if actor.is_beside_road:
        return f"`{actor.name}` would stand in a driving lane, or beyond the ends of `{actor.on}`"
    return beyond_the_end(actor.name, missing, f"`{actor.on}`")


def _without_turns(actor: ScenarioActor, candidates: CandidateBatch) -> str | None:
    """That the turns of a route can be made from nowhere in its network."""
    network = candidates.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, candidates)
    copies = CopyBatch(candidates, np.zeros(1, np.intp), np.ones(1, np.int64))
    route = route_points(actor, copies, lanes)
    written = () if route is None else route.parts
    parts = [part for part in written if isinstance(part, TurnWords)]
    choice = lane_choices(actor, copies, WrittenPlace.of(actor, copies), lanes)[0]
    by_another = names_another(actor, candidates.scenario)
    if not parts or len(parts) < len(written) or choice is None or by_another:
        return None
    allowed = sorted(allowed_lanes(actor, lanes, choice, copies))
    if leads_on(lanes, allowed, [part.turn(0) for part in parts]):
        return None
    turns = ", then ".join(f"`{part.word(0)}`" for part in parts)
    return f"no lane of `{actor.on}` lets `{actor.name}` go {turns} at its next junctions"
