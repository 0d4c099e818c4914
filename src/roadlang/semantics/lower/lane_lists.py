"""Whether what a road or network says of its lanes fits together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...diagnostics import Code, Label
from ...ir.dimension import LENGTH
from ...ir.scenario import LANE_OPTIONS
from ...ir.values import Flag, Items, PassCall, Value
from ...plugins.describing import value_text
from ...plugins.lane_options import SAME_WIDTH
from ...plugins.option_types import QuantityType
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..types.expression_types import TypedExpression
from .randomness import is_random
from .references import resolved

Stated = Mapping[str, TypedExpression]


def lanes_fit(checker: Checker, statement: ast.Geometry, stated: Stated) -> bool:
    """False, reported, where lanes are said twice, contradict each other, or are none."""
    if statement.word == "image":
        return True
    if statement.word == "network" and not _same_in_every_scene(checker, stated):
        return False
    lists = [name for name in ("left", "right") if name in stated]
    if not lists:
        return True
    name = statement.name.text
    if any(option in stated for option in ("lanes", "sidewalks")):
        return _counted_too(checker, statement, stated, lists)
    sides = [_calls(checker, stated[side].value) if side in stated else [] for side in _SIDES]
    if sides == [[], []]:
        checker.report(Code.NO_LANES, stated[lists[0]].span, name=name)
        return False
    if stated.get("oneway") is not None and stated["oneway"].value == Flag(True):
        drives = [any(_kind(checker, call).drivable for call in side or []) for side in sides]
        if all(drives):
            labels = [Label(stated[side].span, "driving lanes") for side in lists]
            help_ = "leave `oneway` out, or list all driving lanes on one side"
            span = stated["oneway"].span
            checker.report(
                Code.ONEWAY_WITH_ONCOMING_LANES, span, labels=labels, name=name, help=help_
            )
            return False
    if "width" in stated and None not in sides:
        both = [*reversed(sides[0] or []), *(sides[1] or [])]
        return _widths_fit(checker, name, both, stated["width"])
    return True


_SIDES = ("left", "right")


def _same_in_every_scene(checker: Checker, stated: Stated) -> bool:
    """The junctions of a network are planned once for all candidates."""
    for option in LANE_OPTIONS:
        typed = stated.get(option)
        if option == "speed_limit" or typed is None or typed.value is None:
            continue
        if is_random(checker, typed.value):
            expected = "the same in every scene: the junctions of a network depend on its lanes"
            checker.report(
                Code.MUST_NOT_BE_RANDOM, typed.span, what=f"`{option}`", expected=expected
            )
            return False
    return True


def _counted_too(
    checker: Checker, statement: ast.Geometry, stated: Stated, lists: list[str]
) -> bool:
    option = "lanes" if "lanes" in stated else "sidewalks"
    assert statement.block is not None
    written = next(o for o in statement.block.options if o.key.text == option)
    checker.report(
        Code.LANES_COUNTED_AND_LISTED,
        written.span,
        labels=[Label(stated[side].span, "listed here") for side in lists],
        help=f"leave `{option}` out",
        option=option,
    )
    return False


def _calls(checker: Checker, value: Value | None) -> list[PassCall] | None:
    """The lanes of a list, from the middle outwards; None where they are drawn."""
    value = resolved(checker, value)
    if not isinstance(value, Items):
        return None
    calls = [resolved(checker, item) for item in value.items]
    return [call for call in calls if isinstance(call, PassCall)] if _are_calls(calls) else None


def _are_calls(values: list[Value | None]) -> bool:
    return all(isinstance(value, PassCall) for value in values)


def _kind(checker: Checker, call: PassCall) -> Any:
    return checker.registry.find(call.verb, call.kind).load()


def _widths_fit(checker: Checker, name: str, lanes: list[PassCall], width: TypedExpression) -> bool:
    """The drivable lanes, with what lies between them, are as wide as the road; those that say no
    width share what the others leave. `lanes` are all of them from left to right."""
    drivable = [place for place, call in enumerate(lanes) if _kind(checker, call).drivable]
    if not drivable or width.value is None:
        return True
    least, most = 0.0, 0.0
    shares = False
    for call in lanes[drivable[0] : drivable[-1] + 1]:
        kind, written = _kind(checker, call), call.common.get("width")
        if written is None and kind.drivable:
            shares = True
            continue
        low, high = (kind.default_width,) * 2 if written is None else checker.bounds_of(written)
        least, most = least + low, most + high
    low, high = checker.bounds_of(width.value)
    if shares and least < high:
        return True
    if not shares and least - SAME_WIDTH <= high and low <= most + SAME_WIDTH:
        return True
    checker.report(
        Code.LANES_DISAGREE_WITH_WIDTH,
        width.span,
        name=name,
        lanes=_meters(least) if least == most else f"{_meters(least)} to {_meters(most)}",
        width=_meters(low) if low == high else f"{_meters(low)} to {_meters(high)}",
        help="leave `width` out, or the width of a drivable lane, which then takes what is left",
    )
    return False


def _meters(value: float) -> str:
    return value_text(round(value, 4), QuantityType(LENGTH))
