"""The parts of a figure by themselves: numbers, text, plots, the photo, the contact sheet."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.api import Picture, Scene
from roadlang.geometry import round_length
from roadlang.geometry.earth.pixel_map import PixelMap
from roadlang.ir.scene import Profile, RoadPlace, SceneSignal
from roadlang_standard.svg import palette
from roadlang_standard.svg.markup import element, group, number, path_data, rho, text
from roadlang_standard.svg.photo import beneath
from roadlang_standard.svg.profiles import profiles, rows_of
from roadlang_standard.svg.sheet import contact_sheet
from roadlang_standard.svg.viewport import BoundingBox, Viewport
from roadlang_standard.svg.wrapping import letters, wrapped
from tests.backends.handmade_scenes import bend


@pytest.mark.parametrize(
    ("value", "shown"),
    [(1.0, "1"), (0.5, "0.5"), (-0.001, "0"), (-0.25, "-0.25"), (12.346, "12.35"), (100.0, "100")],
)
def test_numbers_are_short(value: float, shown: str) -> None:
    assert number(value) == shown


def test_an_element_has_its_attributes_in_the_names_of_svg() -> None:
    assert (
        element("g", class_="a", stroke_width=2.0, fill=None) == '<g class="a" stroke-width="2"/>'
    )
    assert text("a < b & c\x07", 1.0, 2.5) == '<text x="1" y="2.5">a &lt; b &amp; c</text>'


def test_a_path_goes_through_its_points_and_may_close() -> None:
    points = np.array([[0.0, 1.0], [2.5, -3.0]])
    assert path_data(points) == "M0 1L2.5 -3"
    assert path_data(points, closed=True) == "M0 1L2.5 -3Z"


def test_a_robustness_has_three_digits_and_a_real_minus() -> None:
    assert rho(-0.01234) == "\N{GREEK SMALL LETTER RHO} = \N{MINUS SIGN}0.0123"


@pytest.mark.parametrize(
    ("content", "most", "lines"),
    [
        ("always (e < 1)", 14, ["always (e < 1)"]),
        ("always (e < 1)", 13, ["always (e <", "1)"]),
        ("abcdef", 4, ["abcd", "ef"]),
        ("a\N{NO-BREAK SPACE}b c", 3, ["a b", "c"]),
        ("", 10, [""]),
    ],
)
def test_text_is_broken_at_blanks_so_that_each_line_fits(
    content: str, most: int, lines: list[str]
) -> None:
    assert wrapped(content, most) == lines


def test_how_many_letters_fit() -> None:
    assert letters(531.0, 10.0) == 100
    assert letters(1.0, 10.0) == 1


@pytest.mark.parametrize(
    ("meters", "length"),
    [(1.0, 1), (1.9, 1), (2.0, 2), (4.99, 2), (5.0, 5), (73.0, 50), (0.3, 0.2)],
)
def test_a_round_length_is_not_longer(meters: float, length: float) -> None:
    assert round_length(meters) == pytest.approx(length)


STATIONS = (0.0, 50.0, 100.0, 150.0, 200.0)


def judged(values: tuple[float, ...], name: str = "phi1", station: float = 0.0) -> Scene:
    """A scene with one requirement of this robustness along the road."""
    verdict = replace(
        bend().requirements[0],
        name=name,
        robustness=min(values),
        satisfied=min(values) >= 0,
        profiles=(Profile("bent", STATIONS, values),),
        tightest=RoadPlace("bent", station),
    )
    return replace(bend(), requirements=(verdict,), expectations=())


def test_a_signal_is_told_by_its_greatest_magnitude() -> None:
    e1 = SceneSignal("e1", "", "m", (Profile("bent", STATIONS, (1.0, -3.0, 2.0, 0.0, 0.0)),))
    (row,) = rows_of(replace(bend(), signals=(e1,), requirements=(), expectations=()))
    assert (row.note, row.station) == ("up to \N{MINUS SIGN}3 m", 50.0)


def test_of_several_roads_the_one_of_the_extreme_is_plotted() -> None:
    both = (Profile("main", STATIONS, (1.0,) * 5), Profile("bent", STATIONS, (0.5, 4, 0, 0, 0)))
    (row,) = rows_of(replace(bend(), signals=(SceneSignal("e1", "", "m", both),), requirements=()))[
        :1
    ]
    assert row.profile.road == "bent"


def test_a_scene_without_profiles_has_no_plots() -> None:
    assert rows_of(bend()) == []
    assert profiles([], 0.0, 0.0, 100.0, 10.0) == ""


@pytest.mark.parametrize("values", [(4.0, 1.0, 3.0, 2.0, 4.0), (4.0, -2.0, 3.0, -1.0, 4.0)])
def test_the_area_between_robustness_and_zero_is_green_above_and_red_below(
    values: tuple[float, ...],
) -> None:
    drawn = profiles(rows_of(judged(values, station=50.0)), 0.0, 0.0, 400.0, 10.0)
    fills = re.findall(r'fill="(#\w+)" fill-opacity="0.16"', drawn)
    below = [palette.VIOLATIONS[0]] if min(values) < 0 else []
    assert fills == [palette.SATISFIED, *below]
    zero = float(re.findall(r'<line x1="[\d.]+" y1="([\d.]+)"', drawn)[0])
    curve = re.findall(r'd="M([^"Z]+)" fill="none"', drawn)[0]
    heights = [float(pair.split()[1]) for pair in curve.split("L")]
    assert [height < zero for height in heights] == [value > 0 for value in values]
    dot = float(re.findall(r'<circle cx="[\d.]+" cy="([\d.]+)"', drawn)[0])
    assert dot == pytest.approx(heights[1], abs=0.02)


def test_the_photo_lies_with_its_lower_left_corner_at_the_origin() -> None:
    """100 x 60 pixels of half a meter in a map of 10 pixels a meter."""
    frame = Viewport(BoundingBox(-10.0, -10.0, 90.0, 40.0), 5.0, 7.0, 1000.0, 500.0)
    drawn = beneath(Picture(np.zeros((60, 100, 3), np.uint8), 0.5), frame, 0.25)
    found: dict[str, Any] = dict(re.findall(r'(\w+)="([\d.]+)"', drawn))
    placed = [float(found[key]) for key in ("x", "y", "width", "height", "opacity")]
    assert placed == [105.0, 107.0, 500.0, 300.0, 0.75]
    assert beneath(Picture(None, 0.5, characters=("#",)), frame, 0.25) == ""


def test_a_photo_whose_up_is_not_north_is_turned() -> None:
    """Its right is north: each pixel of half a meter is 5 in the map, from (105, 507) up."""
    upright = PixelMap((0.0, 1.0, 0.0, -1.0, 0.0, 99.0), 60, 100)
    frame = Viewport(BoundingBox(-10.0, -10.0, 90.0, 40.0), 5.0, 7.0, 1000.0, 500.0)
    drawn = beneath(Picture(np.zeros((60, 100, 3), np.uint8), 0.5, north_up=upright), frame, 0.25)
    (matrix,) = re.findall(r'transform="matrix\(([^)]+)\)"', drawn)
    assert [float(value) for value in matrix.split()] == [0.0, -5.0, 5.0, 0.0, 105.0, 407.0]
    assert 'width="100" height="60"' in drawn


def test_a_contact_sheet_names_the_nearest_miss_of_each_scene() -> None:
    sheet = contact_sheet([bend(index=0), bend(index=1)], 800.0)
    assert sheet is not None
    assert sheet.count(f">calm: {rho(-0.0113)}<") == 2
    assert ">phi1: " not in sheet
    assert contact_sheet([bend()], 800.0) is None


def test_only_what_is_violated_is_marked_on_the_road() -> None:
    """What is judged when the scene is driven is not violated yet."""
    from roadlang_standard.svg.violations import broken

    assert [verdict.name for verdict in broken(bend())] == ["calm"]


def test_a_group_has_a_line_for_each_child_that_draws_anything() -> None:
    assert group(["<a/>", "", "<b/>"], id="x") == '<g id="x">\n<a/>\n<b/>\n</g>'
    for nothing in ([], [""], ["", ""]):
        assert group(nothing, id="x") == ""


@pytest.mark.parametrize(
    ("length", "labels"),
    [(60, ["0 m", "5", "10"]), (600, ["0 m", "50", "100"]), (6000, ["0 m", "0.5", "1"])],
)
def test_stations_are_marked_about_every_hundred_pixels_at_round_lengths(
    length: int, labels: list[str]
) -> None:
    line = f"road main {{ draw with waypoints {{ points: [(0m, 0m), ({length}m, 0m)] }} }}\n"
    bent = (
        f"road bent from main {{ perturb with sine {{ amplitude: 1m, wavelength: {length}m }} }}\n"
    )
    figure = roadlang.loads(line + bent).sample(1)[0].svg()
    marks = re.search(r'<g[^>]*class="stations".*?</g>', figure, re.DOTALL)
    assert marks is not None
    found = re.findall(r'<text x="([\d.]+)"[^>]*>([^<]+)<', marks[0])
    assert [words for _, words in found[:3]] == labels
    gaps = np.diff([float(x) for x, _ in found])
    assert 50.0 < gaps.min() <= gaps.max() < 100.0
