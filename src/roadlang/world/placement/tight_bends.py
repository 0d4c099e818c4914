"""Where agents would begin in bends that they cannot steer through."""

from __future__ import annotations

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...geometry.arrays import Floats, Integers, wrapped
from ...ir.scenario import ScenarioActor
from ..roads.named_roads import name_of_road
from ..roads.road_places import places_along
from .copies import CopyKinds
from .road_poses import RoadPoses
from .turning import sharpest_turn

AROUND = np.array([-3.0, -1.0, 1.0, 3.0, 5.0])
"""Meters ahead of the middle of an agent between which its lane is looked at: who begins before a
bend has no way to swing out for it."""
TOO_TIGHT = 1.0
"""What is lacking, meters, where an agent cannot follow its lane."""


def lacking_in_bends(
    actor: ScenarioActor,
    candidates: CandidateBatch,
    kinds: CopyKinds,
    index: Integers,
    poses: RoadPoses,
) -> Floats:
    """(n,) `TOO_TIGHT` of the copies at `index` (n,), at these poses in lanes of a network, whose
    lane bends more than they can steer; else 0."""
    lacking = np.zeros(len(index))
    most = len(kinds.instances) // candidates.count
    every = {id(kind): kind for kind in kinds.instances}
    sharpest = {number: sharpest_turn(kind.kind) for number, kind in every.items()}
    limit = np.array([sharpest[id(kinds.instances[row])] for row in index.tolist()])
    in_lane = (poses.lane != 0) & (poses.road >= 0) & np.isfinite(limit)
    for road in np.unique(poses.road[in_lane]).tolist():
        chosen = np.flatnonzero(in_lane & (poses.road == road))
        ahead = np.where(poses.backward[chosen], -1.0, 1.0)[:, None] * AROUND
        at = poses.start[chosen, None] + ahead
        rows = np.repeat(index[chosen] // most, len(AROUND))
        name = str(name_of_road(actor, road))
        places = places_along(name, candidates, rows, at.reshape(-1))
        x, y, heading = (
            column.reshape(at.shape) for column in (places.x, places.y, places.heading)
        )
        offset = poses.offset[chosen, None]
        x, y = x - offset * np.sin(heading), y + offset * np.cos(heading)
        steps = np.hypot(np.diff(x, axis=1), np.diff(y, axis=1))
        turned = np.abs(wrapped(np.diff(heading, axis=1)))
        tight = turned > limit[chosen, None] * np.maximum(steps, 1e-6) + 1e-9
        lacking[chosen] = np.where(tight.any(axis=1), TOO_TIGHT, 0.0)
    return lacking
