"""What the members of a scene must have to do with one another, which a schema cannot say."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from .scene import Scene
from .scene_road import SceneRoad

_COLUMNS = ("reference_stations", "x", "y", "heading", "curvature", "width")


class InconsistentScene(ValueError):
    """Members of a scene that do not fit together; `place` is the way to one of them."""

    def __init__(self, place: str, fault: str) -> None:
        super().__init__(f"{fault} - at `$.{place}`")
        self.place = place


def check_scene(scene: Scene) -> None:
    """Raises `InconsistentScene` for roads whose columns have different lengths or whose lanes
    cannot be, for things on roads that are not there, and for conditions without a formula or
    about what they do not declare."""
    for number, road in enumerate(scene.roads):
        _check_road(road, f"roads[{number}]")
    names = {road.name for road in scene.roads}
    for kind in ("agents", "objects", "markings"):
        for number, actor in enumerate(getattr(scene, kind)):
            if actor.road is not None and actor.road not in names:
                place = f"{kind}[{number}].road"
                raise InconsistentScene(place, f"there is no road `{actor.road}`")
    for place, condition in conditions(scene):
        _check_condition(condition, place)


def _check_road(road: SceneRoad, place: str) -> None:
    count = len(road.stations)
    if count < 2:
        raise InconsistentScene(f"{place}.stations", "a road has at least two stations")
    if any(b <= a for a, b in zip(road.stations, road.stations[1:], strict=False)):
        raise InconsistentScene(f"{place}.stations", "the stations of a road increase")
    lengths: dict[str, tuple[int, ...]] = dict.fromkeys(_COLUMNS, (count,))
    lengths |= {"center_offset": (0, 1, count), "elevation": (0, count)}
    for name, allowed in lengths.items():
        found = len(getattr(road, name))
        if found not in allowed:
            fault = f"{found} numbers, but the road has {count} stations"
            raise InconsistentScene(f"{place}.{name}", fault)
    try:
        road.cross_section()
    except ValueError as error:
        member = "lane_list" if road.lane_list else "width"
        raise InconsistentScene(f"{place}.{member}", str(error)) from error


def conditions(scene: Scene) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Each condition of a scene, with the way to it."""
    for number, verdict in enumerate(scene.expectations):
        if verdict.formula is not None and "monitor" not in verdict.formula:
            yield f"expectations[{number}].formula", verdict.formula
    for number, agent in enumerate(scene.agents):
        for position, call in enumerate(agent.drive):
            for member in ("when", "during"):
                condition = getattr(call, member)
                if condition is not None:
                    yield f"agents[{number}].drive[{position}].{member}", condition


def _check_condition(condition: Mapping[str, Any], place: str) -> None:
    from ..diagnostics import DiagnosticError
    from ..stl import from_json
    from ..stl.formats.json_form import shown

    if "formula" not in condition:
        fault = "a condition needs the member `formula`, which is missing"
        raise InconsistentScene(place, fault)
    try:
        formula = from_json(condition["formula"])
    except DiagnosticError as error:
        message = error.diagnostics[0].message
        raise InconsistentScene(f"{place}.formula", message) from error
    _check_evaluation(condition.get("evaluation", {}), place)
    signals, numbers = condition.get("signals", {}), condition.get("numbers", {})
    if not isinstance(signals, Mapping) or not all(map(_is_call, signals.values())):
        fault = "expected a map from names to signals, each with its `kind` and `options`"
        raise InconsistentScene(f"{place}.signals", fault)
    if not isinstance(numbers, Mapping) or not all(map(_is_number, numbers.values())):
        fault = f"expected a map from names to numbers, found `{shown(numbers)}`"
        raise InconsistentScene(f"{place}.numbers", fault)
    for name in sorted(formula.variables - signals.keys() - numbers.keys()):
        fault = f"`{name}` is neither in `signals` nor in `numbers`"
        raise InconsistentScene(f"{place}.formula", fault)


def _check_evaluation(evaluation: object, place: str) -> None:
    from ..stl.formats.evaluation_json import UnreadableEvaluation, evaluation_from_json
    from ..stl.formats.json_form import shown

    if not isinstance(evaluation, Mapping):
        fault = f'expected a map such as `{{"semantics": "held"}}`, found `{shown(evaluation)}`'
        raise InconsistentScene(f"{place}.evaluation", fault)
    try:
        evaluation_from_json(evaluation)
    except UnreadableEvaluation as error:
        raise InconsistentScene(f"{place}.evaluation.{error.place}", str(error)) from error


def _is_call(value: object) -> bool:
    return (
        isinstance(value, Mapping)
        and isinstance(value.get("kind"), str)
        and isinstance(value.get("options", {}), Mapping)
    )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
