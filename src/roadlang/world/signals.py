"""Road signals and numbers for many candidates."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import build
from ..geometry.arrays import Floats
from ..ir.batch import RoadBatch
from ..ir.scenario import ScenarioNetwork
from ..ir.values import Entity, PassCall, Value
from ..plugins.guard import wrong_result
from ..plugins.results import real_numbers
from .copies import is_group
from .networks import NetworkRoot, edge_batch, network_root
from .placement import start_of
from .roads import road_batch


@dataclass(frozen=True)
class EvaluatedRoad:
    """What a road formula runs along: a road, or one edge of each network it names."""

    edge: int | None = None

    def resolve(self, entity: Entity, candidates: CandidateBatch) -> RoadBatch | NetworkRoot:
        """The road that a name stands for on this axis; the whole network off all axes."""
        if entity.role == "road":
            return road_batch(entity.name, candidates)
        network = candidates.scenario.networks[entity.name]
        if self.edge is None:
            return network_root(network, candidates)
        return edge_with_others(network, self.edge, candidates)


def edge_with_others(network: ScenarioNetwork, edge: int, candidates: CandidateBatch) -> RoadBatch:
    """A road of a network that knows the other roads."""
    root = network_root(network, candidates)
    others = tuple(
        edge_batch(network, other.id, candidates) for other in root.edges if other.id != edge
    )
    return replace(edge_batch(network, edge, candidates), others=others)


def axes_of(call: Value, candidates: CandidateBatch) -> tuple[EvaluatedRoad, ...]:
    """The axes of a formula or call: one for each road of the networks that it names."""
    scenario = candidates.scenario
    names = [e.name for e in scenario.dependencies.entities(call) if e.role == "network"]
    if not names:
        return (EvaluatedRoad(),)
    ids = [
        {edge.id for edge in network_root(scenario.networks[name], candidates).edges}
        for name in names
    ]
    return tuple(EvaluatedRoad(edge) for edge in sorted(set.intersection(*ids)))


def signal(call: PassCall, axis: EvaluatedRoad, candidates: CandidateBatch) -> Floats:
    """(V, S) or (1, S) values along an axis; (V, 1) of a number."""

    def make() -> Floats:
        built = build(call, candidates, resolve=lambda entity: axis.resolve(entity, candidates))
        with built.guarded:
            result = built.kind.values()
        values = real_numbers(result, "values", built.entry, call.span)
        if values.ndim < 2:  # alike in all candidates
            values = values.reshape(1, -1)
        rows, columns = (1, candidates.count), (1, *_stations_of(built.kind))
        if values.ndim != 2 or values.shape[0] not in rows or values.shape[1] not in columns:
            fault = f"gave values of shape {values.shape}, not ({rows[-1]}, {columns[-1]})"
            raise wrong_result(built.entry, call.span, fault)
        if not np.isfinite(values).all():
            raise wrong_result(built.entry, call.span, "gave values that are not finite numbers")
        return values

    return candidates.once(("signal", call_key(call), axis.edge), make)


def _stations_of(kind: Any) -> set[int]:
    """How many stations the roads have that a signal is about."""
    roads = (value for value in vars(kind).values() if isinstance(value, RoadBatch))
    return {len(road.stations) for road in roads}


def measured(call: PassCall, candidates: CandidateBatch, element: int = 0) -> Floats:
    """A number of the geometry, (V, 1): `length(street)`, `van.start`.

    Of a group it is that of the copy `element`; a `CopyBatch` has that of each of its copies.
    """
    if isinstance(candidates, CopyBatch):
        return _of_copies(call, candidates)

    def resolve(entity: Entity) -> Any:
        if entity.role in ("agent", "object"):
            return start_of(candidates.scenario.actors[entity.name], candidates, element)
        return EvaluatedRoad().resolve(entity, candidates)

    def make() -> Floats:
        built = build(call, candidates, resolve=resolve)
        with built.guarded:
            result = built.kind.values()
        values = real_numbers(result, "values", built.entry, call.span)
        if values.size not in (1, candidates.count):
            fault = f"gave values of shape {values.shape}, not ({candidates.count}, 1)"
            raise wrong_result(built.entry, call.span, fault)
        if not np.isfinite(values).all():
            raise wrong_result(built.entry, call.span, "gave values that are not finite numbers")
        return values.reshape(-1, 1)

    return candidates.once(("number", call_key(call), element), make)


def _of_copies(call: PassCall, copies: CopyBatch) -> Floats:
    actors = copies.scenario.actors
    named = [e.name for e in copies.scenario.dependencies.entities(call)]
    if not any(name in actors and is_group(actors[name]) for name in named):
        return copies.of_scene(lambda whole: measured(call, whole))
    found = np.empty((copies.count, 1))
    for copy in np.unique(copies.copies).tolist():
        rows = np.flatnonzero(copies.copies == copy)
        values = measured(call, copies.candidates, copy)
        found[rows] = values[np.minimum(copies.rows[rows], len(values) - 1)]
    return found


def call_key(call: PassCall) -> Hashable:
    """Calls that say the same are computed once."""
    return (call.verb, call.kind, call.options)
