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
from ..ir.placed_batch import PlacedBatch
from ..ir.scenario import ScenarioNetwork
from ..ir.values import Condition, Entity, PassCall, Value
from ..plugins.guard import wrong_result
from ..plugins.results import real_numbers
from .networks.connection_roads import connection_batch
from .networks.networks import NetworkRoot, edge_batch, network_root
from .placement.copies import is_group
from .placement.placement import placed, placed_copy
from .roads.roads import road_batch


@dataclass(frozen=True)
class EvaluatedRoad:
    """What a road formula runs along: a road, or one edge of each network it names, or one
    `connection` (ids of the junction and of the connection) at the junctions of a network."""

    edge: int | None = None
    connection: tuple[int, int] | None = None

    def resolve(self, entity: Entity, candidates: CandidateBatch) -> RoadBatch | NetworkRoot:
        """The road that a name stands for on this axis; the whole network off all axes."""
        if entity.role == "road":
            return road_batch(entity.name, candidates)
        network = candidates.scenario.networks[entity.name]
        if self.connection is not None:
            return connection_road(network, *self.connection, candidates)
        if self.edge is None:
            return network_root(network, candidates)
        return edge_with_others(network, self.edge, candidates)

    def name(self, network: str) -> str:
        """`town/3` of edge 3; `town/junction 2/5` of connection 5 at junction 2."""
        if self.connection is None:
            return f"{network}/{self.edge}"
        return f"{network}/junction {self.connection[0]}/{self.connection[1]}"


def edge_with_others(network: ScenarioNetwork, edge: int, candidates: CandidateBatch) -> RoadBatch:
    """A road of a network that knows the other roads."""
    root = network_root(network, candidates)
    others = tuple(
        edge_batch(network, other.id, candidates) for other in root.edges if other.id != edge
    )
    return replace(edge_batch(network, edge, candidates), others=others)


def axes_of(call: Value, candidates: CandidateBatch) -> tuple[EvaluatedRoad, ...]:
    """The axes of a formula or call: one for each road of the networks that it names, and for each
    connection where all its signals are measured there."""
    scenario = candidates.scenario
    names = [e.name for e in scenario.dependencies.entities(call) if e.role == "network"]
    if not names:
        return (EvaluatedRoad(),)
    ids = [
        {edge.id for edge in network_root(scenario.networks[name], candidates).edges}
        for name in names
    ]
    roads = [EvaluatedRoad(edge) for edge in sorted(set.intersection(*ids))]
    if isinstance(call, Condition) and len(set(names)) == 1 and _on_connections(call, candidates):
        root = network_root(scenario.networks[names[0]], candidates)
        roads += [
            EvaluatedRoad(connection=(junction.id, connection.id))
            for junction in root.junctions.plans[names[0]].junctions
            for connection in junction.connections
        ]
    return tuple(roads)


def _on_connections(condition: Condition, candidates: CandidateBatch) -> bool:
    """Whether all signals of a formula are measured on the connections of junctions."""
    scenario = candidates.scenario
    kinds: list[Any] = [scenario.kind(binding.call)[1] for binding in condition.signals]
    return all(getattr(kind, "on_connections", False) for kind in kinds)


def connection_road(
    network: ScenarioNetwork, junction: int, connection: int, candidates: CandidateBatch
) -> RoadBatch:
    """A connection as a road, the same in all candidates that share the root of the network."""
    root = network_root(network, candidates)
    plan = root.junctions.plans[network.name]
    name = EvaluatedRoad(connection=(junction, connection)).name(network.name)

    def make() -> RoadBatch:
        place = next(item for item in plan.junctions if item.id == junction)
        return connection_batch(name, place.connections[connection])

    return candidates.once(("connection", name), make)


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

    return candidates.once(("signal", call_key(call), axis), make)


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
            actor = candidates.scenario.actors[entity.name]
            if entity.copy:
                return placed_copy(actor, candidates, entity.copy)
            if getattr(candidates.scenario.kind(call)[1], "of_groups", False):
                every = candidates.once(
                    ("all of", entity.name), lambda: placed(actor, candidates), inherited=False
                )
                return _without_named(every, entity, call, candidates)
            return placed_copy(actor, candidates, element)
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


def _without_named(
    every: PlacedBatch, group: Entity, call: PassCall, candidates: CandidateBatch
) -> PlacedBatch:
    """All copies of a group but those that the call names by themselves: nothing is compared with
    itself, as in `distance(cars[0], cars)`."""
    named = candidates.scenario.dependencies.entities(call)
    copies = {e.copy for e in named if e.name == group.name and e.copy}
    if not copies:
        return every
    present = every.present.copy()
    present[:, [copy - 1 for copy in copies if copy <= present.shape[1]]] = False
    return replace(every, present=present)


def _of_copies(call: PassCall, copies: CopyBatch) -> Floats:
    actors = copies.scenario.actors
    named = [e.name for e in copies.scenario.dependencies.entities(call) if not e.copy]
    if not any(name in actors and is_group(actors[name]) for name in named):
        return copies.of_scene(lambda scene: measured(call, scene))
    found = np.empty((copies.count, 1))
    for copy in np.unique(copies.copies).tolist():
        rows = np.flatnonzero(copies.copies == copy)
        values = measured(call, copies.candidates, copy)
        found[rows] = values[np.minimum(copies.rows[rows], len(values) - 1)]
    return found


def call_key(call: PassCall) -> Hashable:
    """Calls that say the same are computed once."""
    return (call.verb, call.kind, call.options)
