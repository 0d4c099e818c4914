"""The agents and objects of scenes."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from itertools import islice, repeat
from typing import Any

from ..evaluate.candidates import CandidateBatch, fixed_candidate
from ..evaluate.concrete import call_of, concrete
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import Booleans
from ..ir.category import PAINTED, category_by_size
from ..ir.placed_batch import PlacedBatch
from ..ir.read_only import frozen
from ..ir.record_columns import records_of
from ..ir.scenario import ScenarioActor, ScenarioNetwork
from ..ir.scene import SceneActor, SceneSensor
from ..ir.values import Measure, PassCall, RandomValue
from ..plugins.common_options import common_options
from ..plugins.finding import find_entry
from ..plugins.guard import plugin_guard
from ..plugins.kinds import ObjectKind
from ..plugins.options import schema_of
from ..world.networks.networks import network_root
from ..world.placement.copies import counts, element_of, is_group, kinds_of, most_copies
from ..world.placement.placement import placed
from ..world.roads.named_roads import name_of_road
from .own_copies import Drives, of_own_copies
from .routes import may_be_on_network, on_network, scene_routes
from .scene_rows import SceneRows
from .start_speeds import start_speeds

_UNUSUAL_HEIGHT = 3.0
_DEFAULT_HEIGHT = 1.5
_POSE = ("x", "y", "heading", "length", "width", "start", "offset", "lane", "backward", "road")
Kinds = list[tuple[str, float, Any, str, str]]
"""The name, the height, the options, the category and the role of the kind of each copy."""
Sensors = list[tuple[SceneSensor, ...]]
"""The sensors of each copy, or of all."""


def scene_actors(
    actors: tuple[ScenarioActor, ...], rows: SceneRows
) -> list[tuple[SceneActor, ...]]:
    """Each actor, or each copy of a group (`trees[0]`)."""
    columns = [_copies_of(actor, rows) for actor in actors]
    if len(columns) == 1:
        return columns[0]
    return [sum(parts, ()) for parts in zip(*columns, strict=True)] if columns else rows.same(())


def objects_and_markings(
    placed: Sequence[tuple[SceneActor, ...]],
) -> tuple[list[tuple[SceneActor, ...]], list[tuple[SceneActor, ...]]]:
    """What is placed in each scene: what stands there, and what is paint."""
    objects, markings = [], []
    for found in placed:
        paint = tuple(thing for thing in found if thing.category in PAINTED)
        is_solid = (thing for thing in found if thing.category not in PAINTED)
        objects.append(tuple(is_solid) if paint else found)
        markings.append(paint)
    return objects, markings


def legend_objects(candidates: CandidateBatch) -> tuple[SceneActor, ...]:
    """What legends of images, and maps, name in addition to roads: `town/tree[0]`."""
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
            category = _kind_category(drawn.kind, candidates)
            usual = 0.0 if category in PAINTED else options.get("height", _UNUSUAL_HEIGHT)
            height = drawn.height or float(usual)
            options |= {"length": drawn.length, "width": drawn.width}
            if drawn.height is not None:
                options["height"] = drawn.height
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
                    category=category,
                )
            )
    return tuple(found)


def _copies_of(actor: ScenarioActor, rows: SceneRows) -> list[tuple[SceneActor, ...]]:
    candidates = rows.candidates
    where = placed(actor, candidates)
    present = counts(actor, candidates).tolist()
    kinds = _kinds(actor, rows, where.present)
    drives = _calls(tuple(actor.drive), "controllers", actor, rows)
    sensors = _sensors(actor, rows)
    is_agent = actor.name in rows.scenario.agents
    speeds = start_speeds(actor, where, drives, rows) if is_agent else rows.same(())
    routes = scene_routes(actor, rows) if is_agent else rows.same(())
    names = _names(actor, max(present, default=0))
    if is_group(actor):
        drives = of_own_copies(drives, actor.name, [names[:count] for count in present])
    columns = {
        "name": [name for count in present for name in names[:count]],
        "drive": _of_copies(drives, present, ()),
        "start_speed": _of_copies(speeds, present, None),
        "route": _of_copies(routes, present, None),
        "sensors": _of_copies(sensors, present, ()),
    }
    shown = [kind for count, of_scene in zip(present, kinds, strict=True)
             for kind in of_scene[:count]]  # fmt: skip
    copies = iter(_placed_copies(actor, where, shown, columns))
    found = [tuple(islice(copies, count)) for count in present]
    if is_agent and may_be_on_network(actor, rows.scenario):
        return [
            tuple(on_network(actor, copy, rows.alone(row)) for copy in of_scene)
            for row, of_scene in enumerate(found)
        ]
    return found


def _placed_copies(
    actor: ScenarioActor, where: PlacedBatch, kinds: Kinds, columns: Mapping[str, Iterable[Any]]
) -> list[SceneActor]:
    """The copies of all scenes, one scene after the other."""
    if not kinds:
        return []
    there = where.present.astype(bool)
    pose = {name: getattr(where, name)[there].tolist() for name in _POSE}
    kind, height, options, category, role = zip(*kinds, strict=True)
    if not all(category):
        sizes = zip(category, pose["length"], pose["width"], height, strict=True)
        category = tuple([stated or category_by_size(*size) for stated, *size in sizes])
    roads = {number: name_of_road(actor, number) for number in set(pose["road"])}
    on_road = actor.on is not None
    whole: dict[str, Iterable[Any]] = {
        **{name: pose[name] for name in ("x", "y", "heading", "length", "width")},
        "group": repeat(actor.name),
        "road": [roads[number] for number in pose["road"]],
        "start": pose["start"] if on_road else repeat(None),
        "offset": pose["offset"] if on_road else repeat(None),
        "lane": [lane or None for lane in pose["lane"]],
        "facing": ["back" if backward else "forward" for backward in pose["backward"]],
        "kind": kind, "height": height, "options": options, "category": category, "role": role,
        **columns,
    }  # fmt: skip
    return records_of(SceneActor, len(kinds), whole)


def _names(actor: ScenarioActor, count: int) -> list[str]:
    return [f"{actor.name}[{copy}]" for copy in range(count)] if is_group(actor) else [actor.name]


def _of_copies(
    scenes: Sequence[Sequence[Any]], present: Sequence[int], without: Any
) -> Iterable[Any]:
    """A value for each copy of each scene, of which there may be one for all copies, or none."""
    if not any(scenes):
        return repeat(without)
    parts = [
        values[:count] if len(values) >= count else [*(values or (without,))] * count
        for values, count in zip(scenes, present, strict=True)
    ]
    return [value for part in parts for value in part]


def _kinds(actor: ScenarioActor, rows: SceneRows, present: Booleans) -> list[Kinds]:
    """Of each copy of each scene, of which `present` (V, N) are there."""
    most = most_copies(actor, rows.candidates)
    kinds = kinds_of(actor, rows.candidates)
    if rows.differ(actor.kind):
        if rows.count > 1:
            kinds.record_in(rows.record, present.reshape(-1))
        shown = _shown(kinds.instances)
        return [shown[row * most : (row + 1) * most] for row in range(rows.count)]
    instances = kinds.instances[:1]
    key = ("shown kind", actor.name)
    shown = rows.scenario.once(key, lambda: _shown(instances)) if instances else []
    return rows.same(shown * most)


def _shown(instances: Sequence[KindInstance]) -> Kinds:
    distinct = {id(found): found for found in instances}
    shown = {}
    for key, found in distinct.items():
        options = _concrete_options(found)
        flat = found.kind.category in PAINTED
        height = 0.0 if flat else float(options.get("height") or _DEFAULT_HEIGHT)
        role = getattr(found.kind, "role", "")
        shown[key] = found.entry.name, height, options, found.kind.category, role
    return [shown[id(found)] for found in instances]


def _concrete_options(found: KindInstance) -> Any:
    names = [field.name for field in dataclasses.fields(found.kind)]
    values = [getattr(found.kind, name) for name in names]
    shown = [value if _is_plain(value) else concrete(value) for value in values]
    return frozen(dict(zip(names, shown, strict=True)))


def _is_plain(value: Any) -> bool:
    kind = type(value)
    return kind is str or kind is bool or (kind is float and math.isfinite(value))


def _calls(
    calls: tuple[PassCall, ...], what: str, actor: ScenarioActor, rows: SceneRows
) -> list[Drives]:
    if rows.differ(*calls):
        return rows.each(partial(_calls_of_one, calls, actor))
    element = element_of(actor)

    def make() -> Drives:
        fixed = fixed_candidate(rows.scenario)
        return [tuple(call_of(call, fixed, element) for call in calls)]

    return rows.same(rows.scenario.once((what, actor.name), make))


def _calls_of_one(
    calls: tuple[PassCall, ...], actor: ScenarioActor, candidates: CandidateBatch
) -> Drives:
    count = most_copies(actor, candidates)
    values = [value for call in calls for value in candidates.scenario.dependencies.contents(call)]
    differs = any(
        isinstance(value, Measure) or (isinstance(value, RandomValue) and value.per == "copy")
        for value in values
    )
    copies = range(1, 1 + (count if differs else min(count, 1)))
    element = (lambda copy: copy) if is_group(actor) else (lambda copy: 0)
    return [tuple(call_of(c, candidates, element(copy)) for c in calls) for copy in copies]


def _sensors(actor: ScenarioActor, rows: SceneRows) -> list[Sensors]:
    names = [sensor.name for sensor in actor.sensors]
    if not names:
        return rows.same([])
    common = {option.name: option.default for option in common_options("sense")}
    calls = _calls(tuple(sensor.call for sensor in actor.sensors), "sensors", actor, rows)
    return [
        [
            tuple(
                SceneSensor(name, call.kind, frozen({**common, **call.options}))
                for name, call in zip(names, of_copy, strict=True)
            )
            for of_copy in of_scene
        ]
        for of_scene in calls
    ]


def _kind_defaults(kind: str, candidates: CandidateBatch) -> dict[str, Any]:
    registry = candidates.scenario.registry
    if not registry.has("object", kind):
        return {}
    entry = find_entry(registry, "object", kind)
    with plugin_guard(entry, None):
        schema = schema_of(entry.load())
    return {option.name: option.default for option in schema if not option.required}


def _kind_category(kind: str, candidates: CandidateBatch) -> str:
    registry = candidates.scenario.registry
    if not registry.has("object", kind):
        return ObjectKind.category
    found: type[ObjectKind] = find_entry(registry, "object", kind).load()  # type: ignore[assignment]
    return found.category
