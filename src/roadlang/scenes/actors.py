"""The agents and objects of one candidate, as a scene holds them."""

from __future__ import annotations

import dataclasses
from typing import Any

from ..evaluate.candidates import CandidateBatch
from ..evaluate.concrete import call_of, concrete
from ..evaluate.evaluation import build
from ..ir.scenario import Actor, Network
from ..ir.scene import SceneActor
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard
from ..plugins.options import schema_of
from ..world.networks import network_root
from ..world.placement import counts, kind_call, pose

_UNUSUAL_HEIGHT = 3.0


def scene_actors(actors: tuple[Actor, ...], candidates: CandidateBatch) -> tuple[SceneActor, ...]:
    """Each actor, or each copy of a group (`trees[0]`)."""
    placed = []
    for actor in actors:
        grouped = "count" in dict(actor.options)
        for copy in range(1, int(counts(actor, candidates)[0]) + 1):
            name = f"{actor.name}[{copy - 1}]" if grouped else actor.name
            placed.append(_placed(name, actor, copy, candidates))
    return tuple(placed)


def legend_objects(candidates: CandidateBatch) -> tuple[SceneActor, ...]:
    """What the legends of the images named, beside roads: `town/tree[0]`."""
    found: list[SceneActor] = []
    networks = candidates.scenario.networks.values()
    bottoms = [n for n in networks if not isinstance(candidates.scenario.source_of(n), Network)]
    for network in bottoms:
        numbers: dict[str, int] = {}
        for thing in network_root(network, candidates).objects:
            group = f"{network.name}/{thing.kind.rpartition('.')[2]}"
            number = numbers[group] = numbers.get(group, -1) + 1
            options = _kind_defaults(thing.kind, candidates)
            height = float(options.get("height", _UNUSUAL_HEIGHT))
            options |= {"length": thing.length, "width": thing.width}
            found.append(
                SceneActor(
                    f"{group}[{number}]",
                    group,
                    thing.kind.rpartition(".")[2],
                    float(thing.x),
                    float(thing.y),
                    float(thing.heading),
                    float(thing.length),
                    float(thing.width),
                    height,
                    options=options,
                )
            )
    return tuple(found)


def _placed(name: str, actor: Actor, copy: int, candidates: CandidateBatch) -> SceneActor:
    call = kind_call(actor, copy, candidates)
    element = copy if "count" in dict(actor.options) else 0
    built = build(call, candidates, element, single=True)
    options = {
        field.name: concrete(getattr(built.kind, field.name))
        for field in dataclasses.fields(built.kind)
    }
    length = float(options.get("length") or 1.0)
    width = float(options.get("width") or 1.0)
    where = pose(actor, (length, width), copy, candidates)
    return SceneActor(
        name,
        actor.name,
        built.entry.name,
        where.x,
        where.y,
        where.heading,
        length,
        width,
        float(options.get("height") or 1.5),
        actor.on,
        where.start,
        where.offset,
        where.lane,
        where.facing,
        options,
        tuple(call_of(drive, candidates, element) for drive in actor.drive),
    )


def _kind_defaults(kind: str, candidates: CandidateBatch) -> dict[str, Any]:
    registry = candidates.scenario.registry
    if not registry.has("object", kind):
        return {}
    entry = find_entry(registry, "object", kind)
    with plugin_guard(entry, None):
        schema = schema_of(entry.load())
    return {option.name: option.default for option in schema if not option.required}
