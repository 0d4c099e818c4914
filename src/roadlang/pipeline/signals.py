"""Road signals and numbers for many candidates."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..ir.batch import RoadBatch
from ..ir.scenario import Network
from ..ir.values import Entity, PassCall, Value
from .blame import wrong_result
from .building import build
from .dependencies import entities_in
from .networks import NetworkRoot, edge_batch, network_root
from .roads import road_batch
from .variants import Variants

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Axis:
    """What a road formula runs along: a road, or one edge of each network it names."""

    edge: int | None = None

    def resolve(self, entity: Entity, variants: Variants) -> RoadBatch | NetworkRoot:
        """The road that a name stands for on this axis; the whole network off all axes."""
        if entity.role == "road":
            return road_batch(entity.name, variants)
        network = variants.plan.networks[entity.name]
        if self.edge is None:
            return network_root(network, variants)
        return edge_with_others(network, self.edge, variants)


def edge_with_others(network: Network, edge: int, variants: Variants) -> RoadBatch:
    """A road of a network that knows the other roads."""
    root = network_root(network, variants)
    others = tuple(
        edge_batch(network, other.id, variants) for other in root.edges if other.id != edge
    )
    return replace(edge_batch(network, edge, variants), others=others)


def axes_of(call: Value, variants: Variants) -> tuple[Axis, ...]:
    """The axes of a formula or call: one for each road of the networks that it names."""
    plan = variants.plan
    names = [e.name for e in entities_in(call, plan.values) if e.role == "network"]
    if not names:
        return (Axis(),)
    ids = [
        {edge.id for edge in network_root(plan.networks[name], variants).edges} for name in names
    ]
    return tuple(Axis(edge) for edge in sorted(set.intersection(*ids)))


def signal(call: PassCall, axis: Axis, variants: Variants) -> Floats:
    """(V, S) or (1, S) values along an axis; (V, 1) of a number."""

    def make() -> Floats:
        built = build(call, variants, resolve=lambda entity: axis.resolve(entity, variants))
        with built.blamed:
            values = np.asarray(built.kind.values(), dtype=np.float64)
        if values.ndim < 2:  # alike in all variants
            values = values.reshape(1, -1)
        rows, columns = (1, variants.count), (1, *_stations_of(built.kind))
        if values.ndim != 2 or values.shape[0] not in rows or values.shape[1] not in columns:
            fault = f"gave values of shape {values.shape}, not ({rows[-1]}, {columns[-1]})"
            raise wrong_result(built.entry, call.span, fault)
        if not np.isfinite(values).all():
            raise wrong_result(built.entry, call.span, "gave values that are not finite numbers")
        return values

    return variants.once(("signal", call_key(call), axis.edge), make)


def _stations_of(kind: Any) -> set[int]:
    """How many stations the roads have that a signal is about."""
    roads = (value for value in vars(kind).values() if isinstance(value, RoadBatch))
    return {len(road.stations) for road in roads}


def measured(call: PassCall, variants: Variants, element: int = 0) -> Floats:
    """A number of the geometry, (V, 1): `length(street)`, `van.start`."""
    from .placement import start_of

    def resolve(entity: Entity) -> Any:
        if entity.role in ("agent", "object"):
            return start_of(variants.plan.actors[entity.name], variants, element)
        return Axis().resolve(entity, variants)

    def make() -> Floats:
        built = build(call, variants, resolve=resolve)
        with built.blamed:
            values = np.asarray(built.kind.values(), dtype=np.float64)
        if values.size not in (1, variants.count):
            fault = f"gave values of shape {values.shape}, not ({variants.count}, 1)"
            raise wrong_result(built.entry, call.span, fault)
        if not np.isfinite(values).all():
            raise wrong_result(built.entry, call.span, "gave values that are not finite numbers")
        return values.reshape(-1, 1)

    return variants.once(("number", call_key(call), element), make)


def call_key(call: PassCall) -> Hashable:
    """Calls that say the same are computed once."""
    return (call.verb, call.kind, call.options)
