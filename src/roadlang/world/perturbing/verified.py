"""What every pass makes is verified before the next one gets it."""

from __future__ import annotations

from typing import TypeVar

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...geometry import Curve
from ...ir.batch import RoadBatch
from ...ir.picture import Extraction, Picture
from ...ir.values import PassCall
from ...plugins.guard import wrong_result

Result = TypeVar("Result", Picture, Extraction, Curve, RoadBatch)


def verified(call: PassCall, noun: str, result: Result, candidates: CandidateBatch) -> Result:
    """What a pass made of `thing` (`town`, `town/3`), verified and seen by the observer.

    Raises RL474, with the name of the plugin, for coordinates that are not finite. That stations
    increase and that roads meet at their nodes, curves and networks verify themselves. Batches of
    several candidates are not looked at: what is accepted of them comes here again by itself.
    """
    if candidates.count == 1:
        for part, points in _points(result):
            if not np.isfinite(points).all():
                fault = f"left {part}`{noun}` with coordinates that are not finite numbers"
                raise wrong_result(candidates.scenario.kind(call)[0], call.span, fault)
    return candidates.scenario.observed(call, result)


def _points(result: object) -> list[tuple[str, np.ndarray]]:
    """The coordinates of what a pass made, and which part of it they are of."""
    if isinstance(result, Extraction):
        edges = result.network.edges
        return [(f"road {edge.id} of ", edge.curve.points) for edge in edges]
    return [("", result.points)] if isinstance(result, Curve | RoadBatch) else []
