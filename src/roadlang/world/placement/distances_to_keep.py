"""How far agents and objects are to be from everything, and how much room two of them lack."""

from __future__ import annotations

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...geometry import Footprints
from ...geometry.arrays import Floats
from ...ir.placed_batch import PlacedBatch
from ...ir.scenario import ScenarioActor
from .actor_numbers import number_of_copies
from .copies import CopyKinds, element_of, kinds_of
from .poses import poses_of
from .room_between import PlacedRectangles, missing_room


def distances_to_keep(actor: ScenarioActor, copies: CopyBatch, kinds: CopyKinds) -> Floats:
    """(R,) meters that copies keep from everything: NaN where nothing is said, -inf where they may
    overlap."""
    options = actor.options
    apart = number_of_copies(actor, "apart", copies, np.nan).copy()
    if "overlap" in options:
        value = np.asarray(evaluate(options["overlap"], copies, element_of(actor)), bool)
        apart[np.broadcast_to(value.reshape(-1), (copies.count,))] = -np.inf
    apart[kinds.are_markings] = -np.inf
    return apart


def missing_between(
    first: ScenarioActor, second: ScenarioActor, candidates: CandidateBatch
) -> float:
    """Meters of room that two lack in the first candidate, 0 where both fit. Neither is a group or
    placed by another. Raises DiagnosticError where their road cannot be made."""
    placed = PlacedRectangles()
    for number, actor in enumerate((first, second)):
        copies, kinds = CopyBatch.every(candidates, 1), kinds_of(actor, candidates)
        poses = poses_of(actor, copies, kinds.lengths, kinds.widths, _nobody)
        boxes = Footprints(poses.x, poses.y, poses.heading, kinds.lengths, poses.width)
        apart = distances_to_keep(actor, copies, kinds)
        missing = missing_room(boxes, copies.rows, apart, placed)[0]
        placed.add_rows(number, boxes, copies.rows, apart)
    return float(missing[0])


def _nobody(other: ScenarioActor) -> PlacedBatch:
    raise LookupError(other.name)
