"""What the scenes of many candidates need, computed for all of them at once."""

from __future__ import annotations

import numpy as np

from ..diagnostics import DiagnosticError
from ..evaluate.candidates import CandidateBatch
from ..ir.batch import RoadBatch
from ..world.placement import placed
from ..world.roads import road_batch
from .roads import share_equal_roads


def prepare_scenes(candidates: CandidateBatch) -> None:
    """Compute what `driven_scene` wants of each, so that it has only rows to take.

    No scene depends on it: what cannot be computed for all is left to each, as are roads that
    differ in their stations. The candidates have a record of their draws.
    """
    scenario = candidates.scenario
    if any(scenario.is_varying(name) for name in (*scenario.roads, *scenario.networks)):
        return
    try:
        for name in scenario.roads:
            _compute(road_batch(name, candidates))
        share_equal_roads(candidates)
        for actor in scenario.actors.values():
            placed(actor, candidates)
    except DiagnosticError:
        return


def _compute(road: RoadBatch) -> None:
    """Properties of a road that are computed when they are first used."""
    with np.errstate(all="ignore"):  # what is no road any more is found when its scene is made
        for name in ("heading", "curvature", "length"):
            getattr(road, name)
