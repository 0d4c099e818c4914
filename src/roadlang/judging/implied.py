"""Requirements that no file writes: agents begin on their roads, and roads do not fold."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.dependencies import walk
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import Actor, Network, Road
from ..ir.values import Draw
from ..world.networks import edge_batch, network_root
from ..world.placement import room
from ..world.roads import road_batch
from .influences import draws_of_start, draws_of_thing, names_of_actor
from .requirement import Requirement

Floats = NDArray[np.float64]


def begins_on_road(actor: Actor, scenario: IndexedScenario) -> Requirement:
    """An agent or object on a road begins on the road; its very ends belong to it."""
    drawn = any(isinstance(value, Draw) for value in walk(actor.at, scenario.values))
    return Requirement(
        name=actor.name,
        text=f"`{actor.name}` begins on `{actor.on}`",
        rho=partial(room, actor),
        cost=8.0 if drawn else 6.0,
        names=names_of_actor(actor, scenario),
        draws=draws_of_start(actor, scenario),
        implied=True,
        span=actor.span,
    )


def perturbed_names(scenario: IndexedScenario) -> list[str]:
    """The roads and networks that have a `perturb` of their own."""
    things: tuple[Road | Network, ...] = (*scenario.roads.values(), *scenario.networks.values())
    return [thing.name for thing in things if any(call.verb == "perturb" for call in thing.passes)]


def does_not_fold(name: str, scenario: IndexedScenario) -> Requirement:
    """A road does not run backward where it was pushed beyond the center of a bend."""
    return Requirement(
        name=name,
        text=f"`{name}` does not fold back on itself",
        rho=partial(_unfolded, name),
        cost=3.0,
        names=frozenset([name]),
        draws=frozenset(draws_of_thing(name, scenario)),
        implied=True,
        span=scenario.thing(name).span,
    )


def _unfolded(name: str, candidates: CandidateBatch) -> Floats:
    """(V,) 1 where no road of that name folds, else -1."""
    scenario = candidates.scenario
    if name in scenario.roads:
        batches = [road_batch(name, candidates)]
    else:
        network = scenario.networks[name]
        edges = network_root(network, candidates).edges
        batches = [edge_batch(network, edge.id, candidates) for edge in edges]
    folded = np.zeros(candidates.count, dtype=bool)
    for batch in batches:
        folded |= batch.folded
    return np.where(folded, -1.0, 1.0)
