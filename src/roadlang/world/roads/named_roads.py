"""Roads by the names that a scene gives them: declared ones, and `town/3` for edge 3 of `town`."""

from __future__ import annotations

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...geometry.arrays import Floats
from ...ir.batch import RoadBatch
from ...ir.scenario import ScenarioActor
from ..lanes.cross_sections import LaneBatch
from ..networks.networks import edge_batch, lanes_of_edge
from .road_lanes import Rows, lane_parts
from .roads import road_batch


def named_road(name: str, candidates: CandidateBatch) -> RoadBatch:
    """A declared road, or the edge of a network, in all candidates."""
    if name in candidates.scenario.roads:
        return road_batch(name, candidates)
    network, edge = _edge(name)
    return edge_batch(candidates.scenario.networks[network], edge, candidates)


def named_lanes(name: str, candidates: CandidateBatch) -> tuple[tuple[Rows, LaneBatch], ...]:
    """As `lane_parts`, also of the edges of networks, which have the same lanes everywhere."""
    if name in candidates.scenario.roads:
        return lane_parts(name, candidates)
    network, edge = _edge(name)
    parent = candidates.scenario.networks[network]
    lanes = candidates.once(
        ("lanes", network, edge), lambda: lanes_of_edge(parent, edge, candidates), inherited=False
    )
    return ((np.arange(candidates.count), lanes),)


def name_of_road(actor: ScenarioActor, number: int) -> str | None:
    """The road that a copy stands on: its own, or that number of its network."""
    return actor.on if number < 0 else f"{actor.on}/{number}"


def length_of_rows(name: str, candidates: CandidateBatch, rows: Rows) -> Floats:
    """(R,) meters of a road in the candidates at `rows` (R,)."""
    length = named_road(name, candidates).length.reshape(-1)
    return np.asarray(length[np.minimum(rows, len(length) - 1)])


def _edge(name: str) -> tuple[str, int]:
    network, _, edge = name.rpartition("/")
    return network, int(edge)
