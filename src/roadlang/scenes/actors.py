"""The agents and objects of one candidate, as a scene holds them."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from functools import partial
from typing import Any

from ..evaluate.candidates import CandidateBatch
from ..evaluate.concrete import call_of, concrete
from ..evaluate.kind_instance import KindInstance
from ..ir.read_only import frozen
from ..ir.scenario import ScenarioActor, ScenarioNetwork
from ..ir.scene import Call, SceneActor
from ..ir.values import Measure, RandomValue
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard
from ..plugins.options import schema_of
from ..world.copies import is_group, kinds_of, most_copies
from ..world.named_roads import name_of_road
from ..world.networks import network_root
from ..world.placement import placed
from .routes import on_network, scene_routes
from .start_speeds import start_speeds

_UNUSUAL_HEIGHT = 3.0
_DEFAULT_HEIGHT = 1.5


def scene_actors(
    actors: tuple[ScenarioActor, ...], candidates: CandidateBatch
) -> tuple[SceneActor, ...]:
    """Each actor, or each copy of a group (`trees[0]`), of a single candidate."""
    return tuple(placed for actor in actors for placed in _copies_of(actor, candidates))


def legend_objects(candidates: CandidateBatch) -> tuple[SceneActor, ...]:
    """What the legends of the images name, in addition to roads: `town/tree[0]`."""
    found: list[SceneActor] = []
    networks = candidates.scenario.networks.values()
    bottoms = [
        n for n in networks if not isinstance(candidates.scenario.source_of(n), ScenarioNetwork)
    ]
    for network in bottoms:
        numbers: dict[str, int] = {}
        for drawn in network_root(network, candidates).objects:
            group = f"{network.name}/{drawn.kind.rpartition('.')[2]}"
            number = numbers[group] = numbers.get(group, -1) + 1
            options = _kind_defaults(drawn.kind, candidates)
            height = float(options.get("height", _UNUSUAL_HEIGHT))
            options |= {"length": drawn.length, "width": drawn.width}
            found.append(
                SceneActor(
                    f"{group}[{number}]",
                    group,
                    drawn.kind.rpartition(".")[2],
                    float(drawn.x),
                    float(drawn.y),
                    float(drawn.heading),
                    float(drawn.length),
                    float(drawn.width),
                    height,
                    options=options,
                )
            )
    return tuple(found)


def _copies_of(actor: ScenarioActor, candidates: CandidateBatch) -> Iterator[SceneActor]:
    where = placed(actor, candidates)
    kinds = kinds_of(actor, candidates)
    grouped = is_group(actor)
    distinct = {id(found): found for found in kinds.instances}
    options = {key: _concrete_options(found) for key, found in distinct.items()}
    drives = _drives(actor, candidates)
    is_agent = actor in candidates.scenario.source.agents
    speeds = start_speeds(actor, where, drives, candidates) if is_agent else []
    routes = scene_routes(actor, candidates) if is_agent else []
    columns = [getattr(where, name)[0].tolist() for name in _POSE]
    for copy, (x, y, heading, length, width, start, offset, lane, backward, road) in enumerate(
        zip(*columns, strict=True)
    ):
        instance = kinds.instances[copy]
        on_road = actor.on is not None
        found = SceneActor(
            f"{actor.name}[{copy}]" if grouped else actor.name,
            actor.name,
            instance.entry.name,
            x,
            y,
            heading,
            length,
            width,
            float(options[id(instance)].get("height") or _DEFAULT_HEIGHT),
            name_of_road(actor, road),
            start if on_road else None,
            offset if on_road else None,
            lane or None,
            "back" if backward else "forward",
            options[id(instance)],
            drives[copy] if len(drives) > 1 else drives[0],
            speeds[copy] if is_agent else None,
            routes[copy] if routes else None,
        )
        yield on_network(actor, found, candidates) if is_agent else found


_POSE = ("x", "y", "heading", "length", "width", "start", "offset", "lane", "backward", "road")


def _concrete_options(found: KindInstance) -> Any:
    fields = dataclasses.fields(found.kind)
    return frozen({field.name: concrete(getattr(found.kind, field.name)) for field in fields})


def _drives(actor: ScenarioActor, candidates: CandidateBatch) -> list[tuple[Call, ...]]:
    """The controllers of each copy, or, where all copies have the same, of all."""
    if not is_group(actor) and not candidates.scenario.dependencies.differ(*actor.drive):
        key = ("controllers", actor.name)
        return candidates.root(key, is_drawn=False, make=partial(_all_drives, actor))
    return _all_drives(actor, candidates)


def _all_drives(actor: ScenarioActor, candidates: CandidateBatch) -> list[tuple[Call, ...]]:
    count = most_copies(actor, candidates)
    values = [
        value for call in actor.drive for value in candidates.scenario.dependencies.contents(call)
    ]
    differs = any(
        isinstance(value, Measure) or (isinstance(value, RandomValue) and value.per == "copy")
        for value in values
    )
    copies = range(1, 1 + (count if differs else min(count, 1)))
    element = (lambda copy: copy) if is_group(actor) else (lambda copy: 0)
    return [tuple(call_of(c, candidates, element(copy)) for c in actor.drive) for copy in copies]


def _kind_defaults(kind: str, candidates: CandidateBatch) -> dict[str, Any]:
    registry = candidates.scenario.registry
    if not registry.has("object", kind):
        return {}
    entry = find_entry(registry, "object", kind)
    with plugin_guard(entry, None):
        schema = schema_of(entry.load())
    return {option.name: option.default for option in schema if not option.required}
