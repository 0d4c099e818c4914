"""`when:` conditions, from the scene's JSON form to the nested lists that the engine evaluates."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from roadlang import stl
from roadlang.api import Code, DiagnosticError

from ..faults import fault
from .frame import SceneOrigin
from .names import plain_name

if TYPE_CHECKING:
    from roadlang.api import Scene

ENGINE = "Godot"
FOREVER = 1e9
SIGNALS = frozenset(
    {
        "speed", "acceleration", "cross_track_error", "progress", "station", "steering", "heading",
        "lateral_acceleration", "jerk", "yaw_rate", "contacts", "distance", "gap", "time",
    }
)  # fmt: skip


def engine_condition(when: Mapping[str, Any], scene: Scene, frame: SceneOrigin) -> Any:
    """The engine's form of a condition. Raises `EngineError` RL513 for what it cannot evaluate."""
    signals: dict[str, Any] = {
        name: _signal(name, call, scene, frame) for name, call in when.get("signals", {}).items()
    }
    signals |= {name: float(value) for name, value in when.get("numbers", {}).items()}
    return engine_formula(stl.from_json(when["formula"]), signals)


def is_known(when: Mapping[str, Any]) -> bool:
    """Whether the engine can evaluate a condition."""
    signals = when.get("signals", {})
    if any(plain_name(str(call["kind"])) not in SIGNALS for call in signals.values()):
        return False
    names = (*signals, *when.get("numbers", {}))
    try:
        engine_formula(stl.from_json(when["formula"]), dict.fromkeys(names, 0.0))
    except DiagnosticError:
        return False
    return True


def engine_formula(formula: stl.Formula, signals: Mapping[str, Any]) -> Any:
    """A formula as nested lists, where `signals` has what its variables become.

    The engine knows the few operators of the normal form: `and`, `or`, `not`, windows on the past
    (`all` and `any` of their samples) and `since`. Raises `EngineError` RL513 for others.
    """
    return _formula(stl.normal_form(formula), signals)


def _formula(formula: stl.Formula, signals: Mapping[str, Any]) -> Any:
    match formula:
        case stl.Truth(value):
            return value
        case stl.Comparison(op, left, right):
            return [op, _term(left, signals), _term(right, signals)]
        case stl.TemporalOperator() if not formula.past:
            raise fault(Code.UNSUPPORTED_CONDITION, engine=ENGINE, what=formula.word)
        case stl.LogicalJunction(()):
            return formula.least
    parts = [_formula(part, signals) for part in formula.parts]
    match formula:
        case stl.Not():
            return ["not", *parts]
        case stl.LogicalJunction():
            return ["and" if formula.least else "or", *parts]
        case stl.UnaryTemporal(interval):
            return ["all" if formula.least else "any", *_bounds(interval), *parts]
        case stl.BinaryTemporal(interval):
            return ["since", *_bounds(interval), *parts]
    raise fault(Code.UNSUPPORTED_CONDITION, engine=ENGINE, what=str(formula))


def _bounds(interval: stl.Interval | None) -> tuple[float, float]:
    if interval is None:
        return 0.0, FOREVER
    return interval.lo, min(interval.hi, FOREVER)


def _term(term: stl.Term, signals: Mapping[str, Any]) -> Any:
    match term:
        case stl.Constant(value):
            return value
        case stl.Variable(name) if name in signals:
            return signals[name]
    parts = [_term(part, signals) for part in term.parts]
    match term:
        case stl.Negate():
            return ["negate", *parts]
        case stl.Arithmetic("+" | "-" | "*" | "/" as op):
            return [op, *parts]
        case stl.Apply(function):
            return [function, *parts]
    raise fault(Code.UNSUPPORTED_CONDITION, engine=ENGINE, what=str(term))


def _signal(name: str, call: Mapping[str, Any], scene: Scene, frame: SceneOrigin) -> Any:
    """A signal as [kind, agent, ...]; an object that stands still is given by its outline."""
    kind = plain_name(str(call["kind"]))
    if kind not in SIGNALS:
        raise fault(Code.UNSUPPORTED_CONDITION, engine=ENGINE, what=name)
    if kind == "time":
        return ["time"]
    options = call.get("options", {})
    names = [str(options[key]) for key in ("agent", "first", "second") if key in options]
    moving = {actor.group for actor in scene.agents} | {actor.name for actor in scene.agents}
    # An object is named second, so that the engine always finds an agent first.
    names.sort(key=lambda entry: entry not in moving)
    out: list[Any] = [kind, *[entry for entry in names if entry in moving]]
    for entry in names:
        if entry not in moving:
            out += _outline(entry, name, scene, frame)
    return out


def _outline(wanted: str, name: str, scene: Scene, frame: SceneOrigin) -> list[float]:
    found = [actor for actor in scene.standing if wanted in (actor.name, actor.group)]
    if len(found) != 1:
        raise fault(Code.UNSUPPORTED_CONDITION, engine=ENGINE, what=name)
    signal = found[0]
    heading = math.remainder(signal.heading, 2 * math.pi)
    return [signal.x - frame.x, signal.y - frame.y, heading, signal.length, signal.width]
