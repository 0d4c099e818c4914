"""Where agents and objects are, for many candidates or for one."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..ir.placed_batch import PlacedBatch
from ..ir.scenario import ScenarioActor
from .copies import CopyKinds, counts, is_group, kinds_of_copies, most_copies
from .poses import poses_of, starts_of
from .roads import road_batch

Floats = NDArray[np.float64]


def kinds_of(actor: ScenarioActor, candidates: CandidateBatch) -> CopyKinds:
    """The kind of every copy, candidates one after the other."""

    def make() -> CopyKinds:
        if most_copies(actor, candidates) == 0:
            return CopyKinds(())
        copies = CopyBatch.every(candidates, most_copies(actor, candidates))
        kinds = kinds_of_copies(actor, copies)
        if candidates.record is not None and candidates.count == 1:
            copies.record_in(candidates.record)
        return kinds

    return candidates.once(("kinds", actor.name), make, inherited=False)


def placed(actor: ScenarioActor, candidates: CandidateBatch) -> PlacedBatch:
    """Where every copy of an agent or object is."""

    def make() -> dict[str, NDArray[Any]]:
        most = most_copies(actor, candidates)
        if most == 0:
            return dict.fromkeys(
                ("present", *_POSE, "length", "width"), np.empty((candidates.count, 0))
            )
        copies = CopyBatch.every(candidates, most)
        kinds = kinds_of(actor, candidates)
        poses = poses_of(actor, copies, kinds.widths)
        if candidates.record is not None:
            copies.record_in(candidates.record)
        present = np.arange(1, most + 1) <= counts(actor, candidates)[:, None]
        parts = {name: getattr(poses, name) for name in _POSE}
        parts |= {"length": kinds.lengths, "width": kinds.widths}
        shaped = {name: part.reshape(candidates.count, most) for name, part in parts.items()}
        return {"present": present, **shaped}

    return PlacedBatch(**candidates.once(("placed", actor.name), make))


_FAR = 1e9
"""Meters to the end of a road that nothing can be beyond"""
_POSE = ("x", "y", "heading", "start", "offset", "lane", "backward")


def start_of(actor: ScenarioActor, candidates: CandidateBatch, copy: int = 1) -> Floats:
    """(V, 1) arc length at which a copy (counted from 1) of an agent or object begins."""
    if actor.on is None:
        raise DiagnosticError(
            diagnose(Code.START_WITHOUT_ROAD, actor.span, name=actor.name, member="start")
        )
    return placed(actor, candidates).copy(copy if is_group(actor) else 1).start


def room(actor: ScenarioActor, candidates: CandidateBatch) -> Floats:
    """(V,) meters from where each copy begins to the nearer end of its road; the least of all."""
    assert actor.on is not None
    road = road_batch(actor.on, candidates)
    if road.closed:
        return np.full(candidates.count, _FAR)
    most = most_copies(actor, candidates)
    if most == 0:
        return np.full(candidates.count, _FAR)
    start = starts_of(actor, CopyBatch.every(candidates, most)).reshape(candidates.count, most)
    inside = np.minimum(start, road.length - start)
    # The last station is the end: rounding must not put 100% beyond it.
    inside = np.where(inside > -1e-9 * road.length, np.maximum(inside, 0.0), inside)
    present = np.arange(1, most + 1) <= counts(actor, candidates)[:, None]
    return np.asarray(np.where(present, inside, _FAR).min(axis=1))
