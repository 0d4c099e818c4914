"""The driving lanes of all roads that are built, as rectangles along their stations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry import Footprints, close_pairs, separation
from ...geometry.arrays import Floats, Integers
from ...ir.batch import RoadBatch
from ...ir.scenario import ScenarioNetwork, ScenarioRoad
from ..networks.networks import edge_batch, network_root
from ..roads.roads import road_batch
from .placement_order import deciding_actors

BESIDE = 3.0
"""Meters along its own road before and behind a thing beside it where it is as near to the lanes as
its `offset` says."""


@dataclass(frozen=True, eq=False)
class RoadStrips:
    """Rectangles (n,): those of a road with one variant belong to group 0, of others to that of
    their candidate. `road` is the number of the road in `names`, `station` arc length along it."""

    boxes: Footprints
    group: Integers
    road: Integers
    station: Floats
    names: tuple[str, ...]
    periods: tuple[float, ...]
    """lengths of closed roads, infinite for others"""


def built_roads(scenario: IndexedScenario) -> tuple[ScenarioRoad | ScenarioNetwork, ...]:
    """What is driven on, drawn in full and built: the last of each chain of roads, and networks
    that nothing perturbed was made from."""
    roads = [road for road in scenario.roads.values() if not has_descendants(road, scenario)]
    networks = [n for n in scenario.networks.values() if not has_perturbed_descendants(n, scenario)]
    return (*roads, *networks)


def has_descendants(road: ScenarioRoad, scenario: IndexedScenario) -> bool:
    """Whether another road is made from a road, and stands in its place."""
    return any(
        scenario.source_of(other) is road or road in scenario.joined_roads(other)
        for other in scenario.roads.values()
    )


def has_perturbed_descendants(network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    """Whether something perturbed is made from a network, which then stands in its place."""
    sources: tuple[ScenarioRoad | ScenarioNetwork, ...] = (
        *scenario.roads.values(),
        *scenario.networks.values(),
    )
    descendants = [
        source
        for source in sources
        if source is not network and network in scenario.ancestry(source)
    ]
    return any(
        scenario.is_joined(heir) or any(call.verb == "perturb" for call in heir.passes)
        for heir in descendants
    )


def road_strips(candidates: CandidateBatch, varying: bool) -> tuple[RoadStrips, ...]:
    """The strips that all candidates share, and those that differ; either may be missing.

    `varying`: also those of roads that differ in their stations, which only a single candidate has.
    """
    key = ("road strips", varying)
    return candidates.once(key, lambda: _strips(candidates, varying), inherited=False)


def depth_in_lanes(
    boxes: Footprints,
    rows: Integers,
    roads: Sequence[str | None],
    start: Floats,
    candidates: CandidateBatch,
    varying: bool,
) -> Floats:
    """(n,) meters that things stand in the driving lanes of some road, 0 beside all of them.

    `rows` are their candidates; `roads` and `start` (n,) say where along their own road they stand,
    of which the part right beside them does not count.
    """
    deepest = np.zeros(len(boxes.x))
    for strips in road_strips(candidates, varying):
        shared = not strips.group.any()
        group = np.zeros(len(rows), np.int64) if shared else rows
        i, j = close_pairs(boxes, strips.boxes, 0.0, group, strips.group)
        numbers = {name: number for number, name in enumerate(strips.names)}
        own_road = np.array([numbers.get(name or "", -1) for name in roads], np.int64)
        away = np.abs(strips.station[j] - start[i])
        away = np.minimum(away, np.abs(np.array(strips.periods)[strips.road[j]] - away))
        half_length = 0.5 * (boxes.length[i] + strips.boxes.length[j]) + BESIDE
        other = (strips.road[j] != own_road[i]) | (away > half_length)
        i, j = i[other], j[other]
        depth = -separation(boxes.take(i), strips.boxes.take(j))
        np.maximum.at(deepest, i, np.maximum(depth, 0.0))
    return deepest


def _strips(candidates: CandidateBatch, varying: bool) -> tuple[RoadStrips, ...]:
    scenario = candidates.scenario
    batches: list[RoadBatch] = []
    for road in built_roads(scenario):
        if deciding_actors(scenario, names={road.name}):
            continue  # it is made after things are placed
        if scenario.is_varying(road.name) and not varying:
            continue
        if isinstance(road, ScenarioRoad):
            batches.append(road_batch(road.name, candidates))
        else:
            edges = network_root(road, candidates).edges
            batches += [edge_batch(road, edge.id, candidates) for edge in edges]
    fixed = [batch for batch in batches if batch.variants == 1 and len(batch.width) == 1]
    different = [batch for batch in batches if batch.variants > 1 or len(batch.width) > 1]
    return tuple(_strip(group) for group in (fixed, different) if group)


def _strip(batches: list[RoadBatch]) -> RoadStrips:
    parts = [_rectangles(batch) for batch in batches]
    columns = [np.concatenate([part[column] for part in parts]) for column in range(7)]
    numbers = np.repeat(np.arange(len(parts)), [len(part[0]) for part in parts])
    names = tuple(batch.name for batch in batches)
    periods = tuple(float(b.length[0, 0]) if b.closed else np.inf for b in batches)
    boxes, station = Footprints(*columns[:5]), columns[6]
    return RoadStrips(boxes, columns[5].astype(np.int64), numbers, station, names, periods)


def _rectangles(road: RoadBatch) -> tuple[Floats, ...]:
    """x, y, heading, length, width, variant and station of the pieces between the stations."""
    points = road.points
    width = np.broadcast_to(road.width, (max(len(road.width), road.variants), points.shape[1]))
    points = np.broadcast_to(points, (len(width), *points.shape[1:]))
    width = np.broadcast_to(width, points.shape[:2])
    if road.closed:
        points = np.concatenate([points, points[:, :1]], axis=1)
        width = np.concatenate([width, width[:, :1]], axis=1)
    steps = np.diff(points, axis=1)
    length = np.hypot(steps[..., 0], steps[..., 1])
    middle = 0.5 * (points[:, 1:] + points[:, :-1])
    station = np.cumsum(length, axis=1) - 0.5 * length
    variant = np.broadcast_to(np.arange(len(points))[:, None], length.shape)
    arrays = (
        middle[..., 0], middle[..., 1], np.arctan2(steps[..., 1], steps[..., 0]), length,
        0.5 * (width[:, 1:] + width[:, :-1]), variant, station,
    )  # fmt: skip
    return tuple(np.asarray(array, np.float64).reshape(-1) for array in arrays)
