"""What a kind is that says nothing about itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    LENGTH,
    Dimension,
    Distribution,
    DriveSignal,
    Integer,
    LaneKind,
    Length,
    Number,
    Piece,
    Reader,
    RoadName,
    Signal,
    option,
)
from roadlang.diagnostics import DiagnosticError
from roadlang.geometry import Curve
from tests.plugins.installed import install

STREET = "road main { draw with segments { pieces: [straight(90m)] }, LANES }\n"


@dataclass(frozen=True)
class Strip(LaneKind):
    """A lane that says nothing."""

    name: ClassVar[str] = "strip"


def test_a_lane_is_a_strip_of_3_m_that_nobody_drives_on() -> None:
    text = STREET.replace("LANES", "right: [drive(3m), strip, strip], left: [drive(3m)]")
    (scene,) = testing.sample(text, kinds=[Strip])
    lanes = {lane.id: lane for lane in scene.record.roads[0].lane_list}
    strip = lanes[-2]
    assert (strip.kind, strip.direction, strip.users) == ("strip", "forward", ())
    assert set(strip.width) == {3.0}
    assert not strip.raised
    assert set(scene.record.roads[0].width) == {6.0}
    assert (lanes[-1].marking, strip.marking) == ("solid", "broken")


@dataclass(frozen=True)
class Shapes(Reader):
    """A road as long as it is told, and what its options were."""

    name: ClassVar[str] = "shapes"
    reads: ClassVar[tuple[str, ...]] = ("road",)
    seen: ClassVar[list[dict[str, Any]]] = []
    length: Length = option(30.0, minimum=1)
    share: Number = option(0.5)
    count: Integer = option(3)

    def read(self, path: Path) -> Any:
        self.seen.append({field.name: getattr(self, field.name) for field in fields(self)})
        points = np.array([[0.0, 0.0], [self.length, 0.0], [2.0 * self.length, 9.0]])
        return Curve.through(points)


def test_a_reader_gets_plain_numbers(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("a road")
    text = 'road main from "a.txt" { read with shapes { length: 40m, count: 5 }, width: 7m }\n'
    testing.sample(text, kinds=[Shapes], folder=tmp_path)
    seen = Shapes.seen[-1]
    assert seen == {"length": 40.0, "share": 0.5, "count": 5}
    assert [type(value) for value in seen.values()] == [float, float, int]


STRANGER = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import LaneKind, hookimpl

@dataclass(frozen=True)
class Tram(LaneKind):
    name: ClassVar[str] = "tram"

@hookimpl
def roadlang_kinds():
    return [Tram]
"""


def test_kinds_under_test_stand_beside_those_of_installed_plugins(site: Path) -> None:
    install(site, "trams", STRANGER)
    found = testing.registry_with(Strip)
    assert found.find("lane", "tram").origin.plugin == "trams"
    assert found.find("lane", "strip").origin.plugin == testing.PLUGIN
    assert found.find("lane", "drive").origin.is_shipped


@dataclass(frozen=True)
class Flat(Signal):
    """A signal that states nothing."""

    name: ClassVar[str] = "flat"


@dataclass(frozen=True)
class Still(DriveSignal):
    """A signal of drives that states nothing."""

    name: ClassVar[str] = "still"


def test_a_signal_may_have_any_number_without_a_unit() -> None:
    assert Flat.range({}) == (float("-inf"), float("inf"))
    assert all(isinstance(end, float) for end in Flat.range({}))
    assert (Flat.unit, Flat.domain, Flat.member, Flat.on_connections) == ("", "road", False, False)
    assert Flat.dimension_of({}).is_pure


def test_a_drive_signal_is_a_member_that_may_look_at_all_of_the_drive() -> None:
    assert (Still.domain, Still.member, Still.looks_back) == ("drive", True, float("inf"))


@dataclass(frozen=True)
class PowerOfWidth(Signal):
    """The width to a power, which says the dimension."""

    name: ClassVar[str] = "power"
    road: RoadName
    power: Integer = option(2, help="exponent")

    @classmethod
    def dimension_of(cls, options: Mapping[str, Any]) -> Dimension:
        return LENGTH ** float(options["power"])

    def values(self) -> Any:
        return self.road.width**self.power


@pytest.mark.parametrize(
    ("call", "limit", "fits"),
    [
        ("power(main)", "99m^2", True),
        ("power(main)", "99m", False),
        ("power(main, 1)", "99m", True),
        ("power(main, 1)", "99m^2", False),
        ("power(main, power: 3)", "999m^3", True),
    ],
)
def test_the_dimension_of_a_signal_may_depend_on_an_option_and_its_default(
    call: str, limit: str, fits: bool
) -> None:
    text = STREET.replace("LANES", "width: 7m") + f"require r: always ({call} < {limit})\n"
    if fits:
        assert len(testing.sample(text, kinds=[PowerOfWidth])) == 1
        return
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(text, kinds=[PowerOfWidth])
    assert [found.code for found in caught.value.diagnostics] == ["RL205"]


@dataclass(frozen=True)
class Slab(Piece):
    """A piece that states nothing."""

    name: ClassVar[str] = "slab"


@dataclass(frozen=True)
class Pick(Distribution):
    """A distribution that states nothing."""

    name: ClassVar[str] = "pick"


def test_bounds_that_are_not_stated_leave_everything_open() -> None:
    assert Slab().least_length() == 0.0
    assert Pick().support() is None
    assert Pick().cells() is None
    assert Pick().simplest() == 0.5
    assert list(Pick().levels(4)) == [0.125, 0.375, 0.625, 0.875]


@pytest.mark.parametrize(
    ("base", "old", "new", "value"),
    [
        (Distribution, "is_whole", "is_integer", True),
        (LaneKind, "usual_width", "default_width", 2.25),
        (LaneKind, "usual_marking", "default_marking", "solid"),
    ],
)
def test_the_old_name_of_a_class_attribute_works_with_a_warning(
    base: type, old: str, new: str, value: object
) -> None:
    with pytest.warns(DeprecationWarning, match=f"`{old}` is now `{new}`") as found:
        kind = type("Old", (base,), {"__doc__": "Of last year.", old: value})
    assert getattr(kind, new) == value
    assert found[0].filename == __file__
