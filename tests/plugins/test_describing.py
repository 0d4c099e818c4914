"""Options in words, as listings and messages have them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang.api import (
    Angle,
    Between,
    Drawer,
    Duration,
    Flag,
    Integer,
    Length,
    ListOf,
    Point,
    Speed,
    Word,
    option,
)
from roadlang.ir.dimension import ANGLE, CURVATURE, LENGTH, PURE, SPEED, Dimension
from roadlang.plugins.describing import bounds_text, default_text, type_text, value_text
from roadlang.plugins.option_types import (
    FlagType,
    IntervalType,
    ListType,
    OptionType,
    PointType,
    QuantityType,
    UnionType,
)
from roadlang.plugins.options import schema_of


@dataclass(frozen=True)
class Many(Drawer):
    """One option of each sort."""

    name: ClassVar[str] = "many"
    needed: Length = option(above=0, maximum=100)
    speed: Speed = option(50 / 3.6, minimum=0, below=120)
    turn: Angle = option(math.pi / 2)
    count: Integer = option(3, minimum=1)
    pause: Duration = option(None)
    start: Point = option((0.0, 2.5))
    points: ListOf[Point] = option((), at_least=0)
    between: Between = option(None)
    loud: Flag = option(True)
    side: Word = option("left", words=("left", "right"))
    size: Length = option("auto", words=("auto",))

    def draw(self, closed: bool) -> Any:
        raise NotImplementedError


OPTIONS = {schema.name: schema for schema in schema_of(Many)}


@pytest.mark.parametrize(
    ("name", "type_", "default", "bounds"),
    [
        ("needed", "length (m)", "", "> 0m, <= 100m"),
        ("speed", "speed (m/s)", "50km/h", ">= 0m/s, < 120m/s"),
        ("turn", "angle (rad)", "90deg", ""),
        ("count", "integer", "3", ">= 1"),
        ("pause", "time (s)", "not set", ""),
        ("start", "point (m)", "(0m, 2.5m)", ""),
        ("points", "list of points (m)", "[]", ""),
        ("loud", "true | false", "true", ""),
        ("side", "left | right", "left", ""),
        ("size", "length (m) | auto", "auto", ""),
    ],
)
def test_an_option_has_a_type_a_default_and_bounds(
    name: str, type_: str, default: str, bounds: str
) -> None:
    found = OPTIONS[name]
    assert (type_text(found), default_text(found), bounds_text(found)) == (type_, default, bounds)


@pytest.mark.parametrize(
    ("value", "dimension", "text"),
    [
        (10.0, SPEED, "10m/s"),  # not 36km/h: it is a plain number as it is
        (50 / 3.6, SPEED, "50km/h"),
        (13.37, SPEED, "13.37m/s"),
        (0.02, CURVATURE, "0.02/m"),
        (-math.pi, ANGLE, "-180deg"),
        (0.1234, ANGLE, "0.1234rad"),
        (math.inf, LENGTH, "inf"),
        (-math.inf, LENGTH, "-inf"),
        (2.0, PURE, "2"),
        (1.5, Dimension(length=1.5), "1.5m^1.5"),
        (None, LENGTH, "not set"),
        (True, PURE, "true"),
    ],
)
def test_a_value_is_written_as_in_a_scene_file(value: Any, dimension: Dimension, text: str) -> None:
    assert value_text(value, QuantityType(dimension)) == text


METERS = QuantityType(LENGTH)


@pytest.mark.parametrize(
    ("value", "type_", "text"),
    [
        ((1.0, math.inf), IntervalType(METERS), "[1m, inf]"),
        ((1.0, 2.5), ListType(METERS), "[1m, 2.5m]"),
        (((0.0, 1.0), (2.0, 3.0)), ListType(PointType(LENGTH)), "[(0m, 1m), (2m, 3m)]"),
        ((80.0, 5.0), PointType(LENGTH, SPEED), "(80m, 5m/s)"),
        ((1.0, 2.0, 3.0), PointType(LENGTH, in_space=True), "(1m, 2m, 3m)"),
        (1.5, UnionType((FlagType(), METERS)), "1.5m"),
        (False, UnionType((FlagType(), METERS)), "false"),
        (1.5, UnionType((FlagType(),)), "1.5"),
        ("two words", METERS, '"two words"'),
    ],
)
def test_lists_points_and_choices_are_written_with_their_units(
    value: Any, type_: OptionType, text: str
) -> None:
    assert value_text(value, type_) == text
