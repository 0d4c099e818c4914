"""Places in a network that a kind of position names: `junction(3)`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import build
from ...geometry.routes.lane_graph import LaneGraph
from ...geometry.routes.legs import RoutePlace
from ...ir.scenario import ScenarioActor
from ...ir.values import PassCall
from ...plugins.guard import wrong_result
from .copies import element_of


def lane_places_of(
    actor: ScenarioActor,
    call: PassCall,
    copies: CopyBatch,
    row: int,
    lanes: LaneGraph,
    allowed: frozenset[int] | None = None,
) -> tuple[RoutePlace, ...]:
    """The places that a position stands for, for one copy; of the `allowed` lanes alone.

    Raises RL472 where the network has no such place, RL474 for what is no place of it.
    """
    single = copies.chosen(np.array([row])) if copies.count > 1 else copies
    built = build(call, single, element_of(actor), single=True)
    with built.guarded:
        found: Any = tuple(built.kind.lane_places(lanes))
    if not all(isinstance(item, RoutePlace) and item.lane < len(lanes.lanes) for item in found):
        raise wrong_result(built.entry, call.span, "gave something that is not a place in a lane")
    chosen = tuple(item for item in found if allowed is None or item.lane in allowed)
    if not chosen:
        span, lane = call.span or actor.span, "there that `lane` and `facing` allow"
        raise DiagnosticError(diagnose(Code.UNKNOWN_LANE, span, road=actor.on, lane=lane))
    return chosen
