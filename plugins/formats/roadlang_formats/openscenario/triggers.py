"""Conditions of controllers (`when`) as triggers, where OpenSCENARIO has such conditions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, Any
from xml.etree.ElementTree import Element

from ..opendrive.elements import put

if TYPE_CHECKING:
    from roadlang.api import Scene

Condition = Callable[[Element], None]
"""Adds what is inside a `Condition` element."""
Groups = Sequence[Sequence[Condition]]
"""One of them must hold, and of that one all conditions; none: from the start."""
_RULES = {
    "<": "lessThan",
    "<=": "lessOrEqual",
    ">": "greaterThan",
    ">=": "greaterOrEqual",
    "==": "equalTo",
    "!=": "notEqualTo",
}
_MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
_NEGATED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
_MOST = 64
"""Groups of a trigger."""


class NotExpressibleError(Exception):
    """OpenSCENARIO has no such condition."""


def put_trigger(parent: Element, tag: str, groups: Groups) -> None:
    """A `StartTrigger` or `StopTrigger`. Without groups it is true from the start."""
    trigger = put(parent, tag)
    for group in groups or ((at_time(0.0),),):
        element = put(trigger, "ConditionGroup")
        for number, condition in enumerate(group, 1):
            name = f"condition {number}"
            inside = put(element, "Condition", name=name, delay=0.0, conditionEdge="none")
            condition(inside)


def at_time(seconds: float) -> Condition:
    """From a time of the simulation on."""
    return _simulation_time(seconds, ">=")


def _simulation_time(seconds: float, sign: str) -> Condition:
    def write(parent: Element) -> None:
        value = put(parent, "ByValueCondition")
        put(value, "SimulationTimeCondition", value=seconds, rule=_RULES[sign])

    return write


def of_entity(name: str, tag: str, **attributes: str | int | float) -> Condition:
    """A condition of one entity. A value that is a name of another is `entityRef`."""

    def write(parent: Element) -> None:
        put(_entity_condition(parent, name), tag, **attributes)

    return write


def _entity_condition(parent: Element, name: str) -> Element:
    found = put(parent, "ByEntityCondition")
    entities = put(found, "TriggeringEntities", triggeringEntitiesRule="any")
    put(entities, "EntityRef", entityRef=name)
    return put(found, "EntityCondition")


def _collision_time(name: str, other: str, value: float, sign: str) -> Condition:
    def write(parent: Element) -> None:
        found = put(
            _entity_condition(parent, name),
            "TimeToCollisionCondition",
            freespace="true",
            rule=_RULES[sign],
            value=value,
            relativeDistanceType="euclidianDistance",
            coordinateSystem="entity",
        )
        target = put(found, "TimeToCollisionConditionTarget")
        put(target, "EntityRef", entityRef=other)

    return write


@dataclass(frozen=True)
class SceneTriggers:
    """Makes triggers of the conditions of a scene."""

    scene: Scene

    def groups(self, condition: Mapping[str, Any]) -> Groups:
        """Of a condition as JSON. Raises NotExpressibleError."""
        return self._formula(condition["formula"], condition, negated=False)

    def _formula(self, formula: Any, condition: Mapping[str, Any], negated: bool) -> Groups:
        if not isinstance(formula, Mapping) or len(formula) != 1:
            raise NotExpressibleError
        ((word, parts),) = formula.items()
        if word == "not":
            return self._formula(parts, condition, not negated)
        if word in ("and", "or"):
            each = [self._formula(part, condition, negated) for part in parts]
            both = (word == "and") != negated
            return _conjunction(each) if both else [group for groups in each for group in groups]
        if word not in _RULES:
            raise NotExpressibleError
        return self._comparison(_NEGATED[word] if negated else word, parts, condition)

    def _comparison(self, sign: str, parts: Any, condition: Mapping[str, Any]) -> Groups:
        signals, numbers = condition.get("signals", {}), condition.get("numbers", {})
        left, right = (numbers.get(p, p) if isinstance(p, str) else p for p in parts)
        if isinstance(left, int | float):
            left, right, sign = right, left, _MIRRORED[sign]
        if not isinstance(right, int | float) or not isinstance(left, str) or left not in signals:
            raise NotExpressibleError
        call = signals[left]
        return self._signal(call["kind"], call["options"], sign, float(right))

    def _signal(self, kind: str, options: Mapping[str, Any], sign: str, value: float) -> Groups:
        if kind == "time":
            return [[_simulation_time(value, sign)]]
        if kind in ("speed", "acceleration"):
            tag = f"{kind.capitalize()}Condition"
            more: dict[str, str | int | float]
            more = {"value": value, "rule": _RULES[sign], "direction": "longitudinal"}
            return [[of_entity(name, tag, **more) for name in self._names(options["agent"])]]
        if kind == "station":
            return [[self._traveled(name, sign, value) for name in self._names(options["agent"])]]
        if kind in ("distance", "gap", "time_headway", "time_to_collision"):
            pairs = product(self._names(options["first"]), self._names(options["second"]))
            each = [_of_pair(kind, first, second, sign, value) for first, second in pairs]
            if len(each) > 1 and sign in ("==", "!="):
                raise NotExpressibleError
            # The distance to a group is that to the nearest of its members.
            return [[one] for one in each] if sign in ("<", "<=") else [each]
        raise NotExpressibleError

    def _traveled(self, name: str, sign: str, station: float) -> Condition:
        """That an agent has passed a station of its road."""
        actor = next(actor for actor in self.scene.agents if actor.name == name)
        backward = actor.facing == "back"
        if actor.start is None or actor.route is not None or (sign in ("<", "<=")) != backward:
            raise NotExpressibleError
        if sign in ("==", "!="):
            raise NotExpressibleError
        distance = actor.start - station if backward else station - actor.start
        return of_entity(name, "TraveledDistanceCondition", value=max(distance, 0.0))

    def _names(self, name: str) -> list[str]:
        """A name, or those of all members of a group."""
        actors = (*self.scene.agents, *self.scene.objects)
        found = [actor.name for actor in actors if name in (actor.name, actor.group)]
        if not found:
            raise NotExpressibleError
        return found


def _of_pair(kind: str, first: str, second: str, sign: str, value: float) -> Condition:
    if kind == "time_to_collision":
        return _collision_time(first, second, value, sign)
    given: dict[str, str | int | float] = {
        "entityRef": second,
        "freespace": "false" if kind == "distance" else "true",
        "rule": _RULES[sign],
        "value": value,
    }
    if kind == "time_headway":
        given |= {"relativeDistanceType": "longitudinal", "coordinateSystem": "lane"}
        return of_entity(first, "TimeHeadwayCondition", **given)
    given |= {"relativeDistanceType": "euclidianDistance", "coordinateSystem": "entity"}
    return of_entity(first, "RelativeDistanceCondition", **given)


def _conjunction(each: Sequence[Groups]) -> Groups:
    found: list[list[Condition]] = []
    for groups in product(*each):
        found.append([condition for group in groups for condition in group])
        if len(found) > _MOST:
            raise NotExpressibleError
    return found
