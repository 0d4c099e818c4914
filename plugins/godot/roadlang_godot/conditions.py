"""`when:` conditions, from the scene's JSON form to the nested lists that the engine evaluates."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from roadlang.api import Code

from .drives import plain_name
from .faults import fault
from .frame import Frame

if TYPE_CHECKING:
    from roadlang.api import Scene

FOREVER = 1e9
SIGNALS = frozenset(
    {
        "speed", "acceleration", "cross_track", "progress", "station", "steering", "heading",
        "lateral_acceleration", "jerk", "yaw_rate", "contacts", "distance", "gap", "time",
    }
)  # fmt: skip
_OPERATORS = frozenset(
    {"and", "or", "not", "implies", "iff", "xor", "<", "<=", ">", ">=", "==", "!=", "+", "-", "*",
     "/", "abs", "min", "max"}
)  # fmt: skip
_PAST = frozenset({"once", "historically", "since"})


def engine_condition(when: Mapping[str, Any], scene: Scene, frame: Frame) -> Any:
    """The engine's form of a condition. Raises `EngineError` RL513 for what it cannot evaluate."""
    signals: dict[str, Any] = {
        name: _signal(name, call, scene, frame) for name, call in when.get("signals", {}).items()
    }
    signals |= {name: float(value) for name, value in when.get("numbers", {}).items()}
    return _tree(when["formula"], signals)


def _tree(value: Any, signals: Mapping[str, Any]) -> Any:
    if isinstance(value, bool) or value is None:
        return bool(value)
    if isinstance(value, (int, float)):
        return float(value)
    if isinstance(value, str):
        if value not in signals:
            raise fault(Code.UNSUPPORTED_CONDITION, what=value)
        return signals[value]
    head = next(word for word in value if word != "interval")
    operands = value[head] if isinstance(value[head], list) else [value[head]]
    parts = [_tree(operand, signals) for operand in operands]
    if head in _PAST:
        low, high = value.get("interval") or (0.0, None)
        return [head, float(low), FOREVER if high is None else float(high), *parts]
    if head == "-" and len(parts) == 1:
        return ["negate", *parts]
    if head not in _OPERATORS:
        raise fault(Code.UNSUPPORTED_CONDITION, what=head)
    return [head, *parts]


def _signal(name: str, call: Mapping[str, Any], scene: Scene, frame: Frame) -> Any:
    """A signal as [kind, agent, ...]; an object that stands still is given by its outline."""
    kind = plain_name(str(call["kind"]))
    if kind not in SIGNALS:
        raise fault(Code.UNSUPPORTED_CONDITION, what=name)
    if kind == "time":
        return ["time"]
    options = call.get("options", {})
    names = [str(options[key]) for key in ("agent", "one", "other") if key in options]
    moving = {actor.group for actor in scene.agents} | {actor.name for actor in scene.agents}
    # An object is named second, so that the engine always finds an agent first.
    names.sort(key=lambda one: one not in moving)
    out: list[Any] = [kind, *[one for one in names if one in moving]]
    for one in names:
        if one not in moving:
            out += _outline(one, name, scene, frame)
    return out


def _outline(wanted: str, name: str, scene: Scene, frame: Frame) -> list[float]:
    found = [actor for actor in scene.objects if wanted in (actor.name, actor.group)]
    if len(found) != 1:
        raise fault(Code.UNSUPPORTED_CONDITION, what=name)
    one = found[0]
    heading = math.remainder(one.heading, 2 * math.pi)
    return [one.x - frame.x, one.y - frame.y, heading, one.length, one.width]
