"""The agents and objects of one candidate, as a scene holds them."""

from __future__ import annotations

import dataclasses
import math
import sys
from typing import Any

from ..evaluate.building import build
from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate, scalar
from ..ir.scenario import Actor, Network
from ..ir.scene import Call, SceneActor
from ..ir.values import Condition, Entity, PassCall
from ..plugins.guard import plugin_guard
from ..plugins.options import schema_of
from ..stl.formats.json_form import to_json
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


def call_of(call: PassCall, candidates: CandidateBatch, element: int = 0) -> Call:
    """A call with every option concrete, defaults included."""
    entry, kind = candidates.scenario.kind(call)
    options = {
        option.name: concrete(option.default) for option in schema_of(kind) if not option.required
    }
    for name, value in (*call.options, *call.common):
        if not isinstance(value, Condition):
            options[name] = concrete(evaluate(value, candidates, element), candidates, element)
    conditions = [v for _, v in (*call.options, *call.common) if isinstance(v, Condition)]
    when = condition_json(conditions[0], candidates, element) if conditions else None
    return Call(entry.recorded, options, when)


def condition_json(
    condition: Condition, candidates: CandidateBatch, element: int = 0
) -> dict[str, Any]:
    """A formula with its signals and numbers: what judges it later needs nothing else."""
    return {
        "text": condition.text,
        "formula": _finite(to_json(condition.formula)),
        "signals": {
            binding.variable: {
                "kind": candidates.scenario.kind(binding.call)[0].recorded,
                "options": {
                    name: concrete(evaluate(value, candidates, element), candidates, element)
                    for name, value in binding.call.options
                },
            }
            for binding in condition.signals
        },
        "numbers": {
            binding.variable: _finite(float(scalar(evaluate(binding.value, candidates, element))))
            for binding in condition.numbers
        },
    }


def _finite(value: Any) -> Any:
    """JSON has no infinity: the greatest number compares as it does."""
    if isinstance(value, float) and math.isinf(value):
        return math.copysign(sys.float_info.max, value)
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    return value


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
    entry = registry.find("object", kind)
    with plugin_guard(entry, None):
        schema = schema_of(entry.load())
    return {option.name: option.default for option in schema if not option.required}


def concrete(value: Any, candidates: CandidateBatch | None = None, element: int = 0) -> Any:
    """Plain JSON values of one candidate: names of things, nested calls as maps."""
    if isinstance(value, Entity):
        return value.name
    if isinstance(value, PassCall):
        assert candidates is not None
        call = call_of(value, candidates, element)
        return {"kind": call.kind, "options": dict(call.options)}
    value = scalar(value)
    if isinstance(value, float) and math.isinf(value):
        return "inf" if value > 0 else "-inf"
    if isinstance(value, tuple):
        return [concrete(item, candidates, element) for item in value]
    if isinstance(value, dict):
        return {key: concrete(item, candidates, element) for key, item in value.items()}
    return value
