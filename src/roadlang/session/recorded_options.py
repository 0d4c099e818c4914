"""The options of the calls in a scene that was read: what the schemas of their kinds allow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from typing import Any, NamedTuple

from ..ir.scene import Scene
from ..ir.scene_actor import SceneActor
from ..ir.scene_consistency import InconsistentScene, conditions
from ..plugins.attribution import PluginFault, attributed
from ..plugins.common_options import common_options
from ..plugins.drive_signals import named_entities
from ..plugins.given_options import given_options, option_faults
from ..plugins.options import OptionSchema
from ..plugins.registry import AmbiguousKind, KindEntry, Registry

_SIZES = ("length", "width", "height")
"""Members of agents and objects that are options of most of their kinds too."""


class _RecordedCall(NamedTuple):
    """A call in a scene, and the way to it."""

    verb: str
    kind: str
    options: Mapping[str, Any]
    place: str


def check_options(scene: Scene, registry: Registry) -> None:
    """Raises `InconsistentScene` for an option or size of an agent or object, and for an option of
    a controller, sensor, simulator or drive signal, that a scene file could not have given it, and
    for a signal of what is not in the scene.

    What the registry does not have is reported where it is used. Options that kinds do not have,
    such as those of another version, are ignored, except for those of drive signals.
    """
    for thing, call in _things(scene):
        entry = _entry(call, registry)
        if entry is not None:
            sizes = {each.name: each for each in entry.options if each.name in _SIZES}
            for name, schema in sizes.items():
                _check_value(getattr(thing, name), schema, call, f"{call.place}.{name}")
            _check_values(call, entry.options)
    for call in _calls(scene):
        entry = _entry(call, registry)
        if entry is not None:
            common = common_options("sense") if call.verb == "sense" else ()
            _check_values(call, (*entry.options, *common))
    things = (*scene.agents, *scene.standing)
    names = {thing.name for thing in things} | {thing.group for thing in things}
    for call in _signals(scene):
        entry = _entry(call, registry)
        if entry is not None:
            _check_names(call, entry.options)
            _check_values(call, entry.options)
            _check_entities(call, named_entities(entry, call.options), names)


def _things(scene: Scene) -> Iterator[tuple[SceneActor, _RecordedCall]]:
    for verb, member in (("agent", "agents"), ("object", "objects"), ("object", "markings")):
        for number, thing in enumerate(getattr(scene, member)):
            yield thing, _RecordedCall(verb, thing.kind, thing.options, f"{member}[{number}]")


def _calls(scene: Scene) -> Iterator[_RecordedCall]:
    for number, agent in enumerate(scene.agents):
        for position, call in enumerate(agent.drive):
            place = f"agents[{number}].drive[{position}]"
            yield _RecordedCall("drive", call.kind, call.options, place)
        for position, sensor in enumerate(agent.sensors):
            place = f"agents[{number}].sensors[{position}]"
            yield _RecordedCall("sense", sensor.kind, sensor.options, place)
    if scene.simulate is not None:
        yield _RecordedCall("simulate", scene.simulate.kind, scene.simulate.options, "simulate")


def _signals(scene: Scene) -> Iterator[_RecordedCall]:
    for place, condition in conditions(scene):
        for name, signal in condition.get("signals", {}).items():
            way = f'{place}.signals["{name}"]'
            yield _RecordedCall("drive_signal", signal["kind"], signal.get("options", {}), way)


def _entry(call: _RecordedCall, registry: Registry) -> KindEntry | None:
    """None where the kind cannot be had."""
    if not registry.has(call.verb, call.kind):
        return None
    try:
        entry = registry.find(call.verb, call.kind)
        with attributed():
            entry.load()
    except (AmbiguousKind, PluginFault):
        return None
    return entry


def _check_values(call: _RecordedCall, schemas: tuple[OptionSchema, ...]) -> None:
    for schema in schemas:
        if call.options.get(schema.name) is None and schema.required:
            fault = f"`{call.verb} {call.kind}` needs the option `{schema.name}`"
            raise InconsistentScene(f"{call.place}.options", fault)
        if schema.name not in call.options:
            continue
        place = f"{call.place}.options.{schema.name}"
        _check_value(call.options[schema.name], schema, call, place)


def _check_value(value: object, schema: OptionSchema, call: _RecordedCall, place: str) -> None:
    given = given_options([schema], {schema.name: value})
    for found in option_faults(call.kind, [schema], given):
        raise InconsistentScene(place, found.message)


def _check_names(call: _RecordedCall, schemas: tuple[OptionSchema, ...]) -> None:
    known = [schema.name for schema in schemas]
    for name in call.options:
        if name not in known:
            fault = f"`{call.verb} {call.kind}` has no option `{name}`"
            raise InconsistentScene(f"{call.place}.options.{name}", fault)


def _check_entities(call: _RecordedCall, entities: Mapping[str, str], names: Set[str]) -> None:
    for option, name in entities.items():
        if name not in names:
            fault = f"the scene has no agent or object `{name}`"
            raise InconsistentScene(f"{call.place}.options.{option}", fault)
