"""One candidate made into a scene."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

from ..ir.scene import Provenance, Scene
from ..ir.values import PassCall
from .evaluation import evaluate, named
from .scene_actors import call_of, concrete, legend_objects, scene_actors
from .scene_roads import scene_networks, scene_roads
from .variants import Variants
from .verdicts import verdict


def realise(variants: Variants, index: int, overrides: dict[str, str] | None = None) -> Scene:
    """The scene of the only candidate; `index` is its number.

    Evaluated by itself, so that its bytes do not depend on what it was searched with.
    """
    plan = variants.plan
    scenario = plan.scenario
    # All that is drawn is drawn before it is listed.
    roads, networks = scene_roads(variants), scene_networks(variants)
    agents = scene_actors(scenario.agents, variants)
    objects = (*scene_actors(scenario.objects, variants), *legend_objects(variants))
    values = {item.name: _plain(named(item.name, variants), variants) for item in scenario.values}
    world = {name: _plain(evaluate(value, variants), variants) for name, value in scenario.world}
    simulate = None if scenario.simulate is None else call_of(scenario.simulate, variants)
    return Scene(
        name=scenario.header.name,
        title=scenario.header.title,
        index=index,
        provenance=provenance(variants, index, overrides or {}),
        values=values,
        draws=_draws(variants),
        networks=networks,
        roads=roads,
        agents=agents,
        objects=objects,
        world=world,
        requirements=tuple(verdict(item, variants) for item in scenario.requirements),
        expectations=tuple(verdict(item, variants) for item in scenario.expectations),
        simulate=simulate,
    )


def provenance(variants: Variants, index: int, overrides: dict[str, str]) -> Provenance:
    """What a scene was made from and by."""
    plan = variants.plan
    return Provenance(
        roadlang=_version("roadlang"),
        seed=variants.seed,
        scene=index,
        attempt=int(variants.attempts[0]),
        inputs=dict(sorted(plan.digests.items())),
        plugins=plan.origins(),
        overrides=overrides,
    )


def _version(distribution: str) -> str:
    try:
        return version(distribution)
    except PackageNotFoundError:
        return "0+unknown"


def _draws(variants: Variants) -> dict[str, Any]:
    """Every random value by its place; where there are several, by number (`place[2]`)."""
    named: dict[str, Any] = {}
    for key, value in variants.kept("draw"):
        place, element = key[1], key[2]
        name = f"{place}[{element}]" if element else place
        named[name] = _plain(value, variants)
    return dict(sorted(named.items()))


def _plain(value: Any, variants: Variants) -> Any:
    if isinstance(value, PassCall):
        return value.kind.rpartition(".")[2]
    if isinstance(value, np.ndarray) and value.dtype == object:
        return _plain(value.reshape(-1)[0], variants)
    return concrete(value, variants)
