"""Roads as shapes of a figure, by hand: a road eastward in the middle of a page of 100 m x 50 m."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.drive.lane_lines import painted_lines, shown_part
from roadlang.ir.scene_lane import SceneLane
from roadlang_standard.svg import ghost, labels, palette
from roadlang_standard.svg.lanes import bands, lane_lines
from roadlang_standard.svg.ribbon import ribbon_of
from roadlang_standard.svg.roads import roads
from tests.backends.handmade_scenes import bend, through
from tests.backends.svg_shapes import (
    PAGE,
    Shape,
    ends,
    numbers,
    of,
    points,
    straight,
    straight_ribbon,
    written,
)

FONT = 10.0


def near(*values: float) -> object:
    return pytest.approx(values, abs=0.02)


def of_lanes(*lanes: SceneLane, center: float = 0.0) -> dict[str, Any]:
    return {"lane_list": lanes, "center_offset": (center,) * 400, "lanes": len(lanes)}


def lane(number: int, kind: str, width: float, **changes: Any) -> SceneLane:
    drivable = kind in ("drive", "bus")
    plain = SceneLane(id=number, kind=kind, width=(width,) * 400, direction="forward",
                      drivable=drivable)  # fmt: skip
    return replace(plain, **changes)


def test_lines_along_a_road() -> None:
    """`line` takes -1 for the right edge, 1 for the left one, and pixels further left."""
    ribbon = straight_ribbon()
    for share, shift, y in [(0, 0, 250), (1, 0, 210), (-1, 0, 290), (0.5, 0, 230), (1, 6, 204)]:
        line = ribbon.line(share, shift)
        assert (*line[0], *line[-1]) == near(0, y, 1000, y)
    assert ribbon.beside(30.0)[0] == near(0, 220)
    assert ribbon.half[0] == pytest.approx(40)


def test_a_tight_bend_is_drawn_round() -> None:
    """A quarter of a circle of 4 m with a station every meter: the line stays on the circle."""
    angles = np.linspace(0.0, np.pi / 2.0, 8)
    stations = 4.0 * angles
    x, y = 50.0 + 4.0 * np.sin(angles), 29.0 - 4.0 * np.cos(angles)
    road = replace(
        through("bend", list(zip(x.tolist(), y.tolist(), strict=True))),
        stations=tuple(stations), reference_stations=tuple(stations), x=tuple(x), y=tuple(y),
        heading=tuple(angles), curvature=(0.25,) * 8, width=(3.0,) * 8, length=float(stations[-1]),
    )  # fmt: skip
    ribbon = ribbon_of(road, PAGE)
    middle = PAGE.place(np.array([[50.0, 29.0]]))[0]
    away = np.hypot(*(ribbon.center - middle).T) / PAGE.pixels_per_meter
    assert np.abs(away - 4.0).max() < 1e-9
    turns = np.diff(np.arctan2(*(ribbon.center - middle).T))
    assert np.abs(turns).max() < 0.1
    assert len(ribbon.center) > 20


def test_the_outline_of_a_road_may_leave_its_casing() -> None:
    outline = straight_ribbon().outline(3.0)
    count = len(outline) // 2
    corners = [*outline[0], *outline[count - 1], *outline[count], *outline[-1]]
    assert corners == near(0, 213, 1000, 213, 1000, 287, 0, 287)


def test_a_casing_leaves_something_of_a_narrow_road() -> None:
    """0.6 px of a road of 4 px are left, however wide its casing."""
    outline = straight_ribbon(width=(0.4,) * 400).outline(10.0)
    assert (outline[0][1], outline[-1][1]) == near(249.7, 250.3)


def test_a_part_of_a_road_is_cut_between_its_stations() -> None:
    part = straight_ribbon().part(20.0, 30.0)
    assert (*part.center[0], *part.center[-1]) == near(200, 250, 300, 250)
    assert part.center[1][0] == pytest.approx(1000 * 80 / 399, abs=0.01)
    assert (part.stations[0], part.stations[-1]) == near(20.0, 30.0)
    assert part.line(1.0)[0] == near(200, 210)
    beyond = straight_ribbon().part(-5.0, 500.0)
    assert (beyond.center[0][0], beyond.center[-1][0]) == near(0, 1000)


def test_a_part_may_be_measured_along_the_root() -> None:
    half = tuple(s / 2 for s in straight().stations)
    part = straight_ribbon(reference_stations=half).part(10.0, 20.0, by_reference=True)
    assert (part.center[0][0], part.center[-1][0]) == near(200, 400)


def test_points_nearer_than_the_eye_can_tell_are_left_out() -> None:
    """4000 points over 1000 pixels: one in each 1.2 pixels is kept, and the last."""
    line = through("line", [(100.0 * i / 3999, 25.0) for i in range(4000)])
    ribbon = ribbon_of(replace(line, width=(8.0,) * 4000), PAGE)
    assert len(ribbon.center) in (833, 834, 835)
    assert ribbon.center[-1][0] == pytest.approx(1000)
    assert np.diff(ribbon.center[:-1, 0]).min() > 1.2 - 0.26
    assert len(ribbon.stations) == len(ribbon.reference) == len(ribbon.half) == len(ribbon.left)


def test_a_road_too_narrow_to_see_is_widened_to_3_5_pixels() -> None:
    thin, fine = straight_ribbon(width=(0.2,) * 400), straight_ribbon(width=(0.36,) * 400)
    assert (thin.line(1.0)[0][1], thin.line(-1.0)[0][1]) == near(248.25, 251.75)
    assert thin.widened
    assert not fine.widened
    assert fine.line(1.0)[0][1] == pytest.approx(248.2)


def test_a_closed_road_returns_to_its_first_point() -> None:
    angles = np.linspace(0.0, 2 * np.pi, 100, endpoint=False)
    ring = through("ring", [(50 + 20 * np.cos(a), 25 + 20 * np.sin(a)) for a in angles])
    length = 2 * np.pi * 20
    ribbon = ribbon_of(replace(ring, closed=True, length=length), PAGE)
    assert ribbon.center[-1].tolist() == ribbon.center[0].tolist()
    assert ribbon.stations[-1] == pytest.approx(length)
    assert ribbon.reference[-1] == pytest.approx(length, rel=1e-3)


def lines_of(drawn: list[Shape]) -> list[tuple[float, float]]:
    """Height and width of each line along the road."""
    return [(points(line)[0][1], numbers(line, "stroke-width")[0]) for line in drawn]


def test_edge_lines_are_painted_inside_the_road_and_the_middle_is_broken() -> None:
    """Lanes of 40 px: lines of 1.4 px, those at the edges 0.25 m inside."""
    drawn = of(lane_lines(straight_ribbon(), 40.0, 10.0), "path")
    assert [value for line in lines_of(drawn) for value in line] == near(
        212.5, 1.4, 250, 1.4, 287.5, 1.4
    )
    assert [line.get("stroke-dasharray") for line in drawn] == [None, "30.00 60.00", None]


@pytest.mark.parametrize(("pixels", "width"), [(10.0, 0.5), (20.0, 0.7), (100.0, 2.0)])
def test_lines_are_wider_on_wide_lanes_within_limits(pixels: float, width: float) -> None:
    drawn = of(lane_lines(straight_ribbon(), pixels, 10.0), "path")
    assert numbers(drawn[1], "stroke-width") == [width]


def test_dashes_can_be_seen_on_a_small_map() -> None:
    """3 m and a gap of 6 m, but at least 5 pixels."""
    drawn = of(lane_lines(straight_ribbon(), 40.0, 1.0), "path")
    assert drawn[1].get("stroke-dasharray") == "5.00 10.00"


def test_a_double_line_is_one_to_each_side() -> None:
    ribbon = straight_ribbon(**of_lanes(lane(1, "drive", 4.0), lane(-1, "drive", 4.0)),
                             center_marking="double")  # fmt: skip
    heights = sorted(y for y, _ in lines_of(of(lane_lines(ribbon, 40.0, 10.0), "path")))
    assert {round(y, 2) for y in heights} >= {248.32, 251.68}


def test_a_curb_is_20_cm_wide_at_the_very_border() -> None:
    lanes = (lane(1, "drive", 4.0, marking="curb"), lane(-1, "drive", 4.0, marking="none"))
    drawn = of(lane_lines(straight_ribbon(**of_lanes(*lanes)), 40.0, 10.0), "path")
    curbs = [line for line in drawn if line.get("stroke") == palette.CURB]
    assert [value for line in lines_of(curbs) for value in line] == near(210, 2.0)


def test_a_figure_of_a_drive_has_the_lines_of_the_figure_of_its_scene() -> None:
    """At one scale: as many lines, as wide, as broken and at the same places."""
    lanes = (
        lane(2, "sidewalk", 2.0, marking="none"),
        lane(1, "drive", 4.0, marking="curb"),
        lane(-1, "bus", 4.0, marking="broken"),
        lane(-2, "drive", 4.0, marking="solid"),
    )
    main = straight(25.0, **of_lanes(*lanes), center_marking="double")
    of_scene = [
        (y, width, line.get("stroke-dasharray"))
        for line in of(lane_lines(ribbon_of(main, PAGE), 40.0 / 1.5, 10.0), "path")
        for y, width in lines_of([line])
    ]
    part = shown_part(main)
    assert part is not None
    of_drive = [
        (PAGE.place(line)[0, 1], stroke.width, stroke.dashes)
        for line, stroke in painted_lines(part, 10.0)
    ]
    assert len(of_drive) == 5
    for (y, width, dashes), (as_y, as_width, as_dashes) in zip(of_scene, of_drive, strict=True):
        assert (y, width) == near(float(as_y), as_width)
        assert dashes == (as_dashes and " ".join(f"{part:.2f}" for part in as_dashes))


def test_parking_spaces_are_5_5_meters_long_and_centered() -> None:
    """18 spaces fit on 100 m and leave 0.5 m at each end."""
    lanes = (lane(1, "drive", 6.0, marking="none"), lane(-1, "parking", 2.0, marking="none"))
    ribbon = straight_ribbon(**of_lanes(*lanes), center_marking="none")
    stalls = of(lane_lines(ribbon, 40.0, 10.0), "path")
    assert len(stalls) == 19
    # The border between the lanes is the reference line; the strip lies to its right.
    assert ends(stalls[0]) == near(5, 250, 5, 270)
    assert ends(stalls[1]) == near(60, 250, 60, 270)
    assert ends(stalls[18]) == near(995, 250, 995, 270)
    assert numbers(stalls[0], "stroke-width") == near(0.8 * 1.4)
    assert not of(lane_lines(ribbon, 40.0, 0.7), "path")
    assert not of(lane_lines(ribbon.part(0.0, 5.0), 40.0, 10.0), "path")


def test_lanes_beside_the_roadway_leave_its_casing() -> None:
    lanes = (lane(2, "sidewalk", 2.0), lane(1, "drive", 3.0), lane(-1, "drive", 3.0),
             lane(-2, "grass", 1.0))  # fmt: skip
    ribbon = straight_ribbon(**of_lanes(*lanes))
    sidewalk, grass = of(bands(ribbon, 1.5, inner=False), "path")
    assert [sidewalk.get("fill"), grass.get("fill")] == [
        palette.LANES[k] for k in ("sidewalk", "grass")
    ]
    assert ends(sidewalk) == near(0, 201.5, 0, 220)
    assert ends(grass) == near(0, 280, 0, 288.5)
    assert not of(bands(ribbon, 1.5, inner=True), "path")


def test_a_median_lies_between_drivable_lanes() -> None:
    lanes = (lane(1, "drive", 3.0), lane(-1, "median", 2.0), lane(-2, "drive", 3.0))
    ribbon = straight_ribbon(**of_lanes(*lanes))
    (median,) = of(bands(ribbon, 1.5, inner=True), "path")
    assert ends(median) == near(0, 250, 0, 270)
    assert not of(bands(ribbon, 1.5, inner=False), "path")
    assert ribbon.drivable == (0, 3)


def test_a_road_has_a_casing_around_its_surface() -> None:
    """1.1 px on each side; less on a road that is thin in the drawing."""
    for width, casing in ((8.0, 1.1), (0.4, 0.22 * 2)):
        scene = replace(bend(), roads=(straight(width=(width,) * 400),))
        ribbons = {"main": ribbon_of(scene.roads[0], PAGE)}
        below, top = of(roads(scene, ribbons, ["main"], PAGE), "path")[:2]
        edge = 250 - 5 * width
        assert (points(below)[0][1], points(top)[0][1]) == near(edge, edge + casing)


def test_roads_with_lanes_too_narrow_to_see_have_no_markings() -> None:
    for width, marked in ((0.81, True), (0.79, False)):
        scene = replace(bend(), roads=(straight(width=(width,) * 400),))
        ribbons = {"main": ribbon_of(scene.roads[0], PAGE)}
        drawn = roads(scene, ribbons, ["main"], PAGE)
        assert ('class="markings"' in drawn) == marked


def test_a_road_is_left_out_where_junctions_take_its_place() -> None:
    """Its markings end at the trims; its surface goes on 0.3 m to leave no seam."""
    scene = replace(bend(), roads=(straight(trim=(10.0, 20.0)),))
    ribbons = {"main": ribbon_of(scene.roads[0], PAGE)}
    drawn = of(roads(scene, ribbons, ["main"], PAGE), "path")
    xs = [x for x, _ in points(drawn[0])]
    assert (min(xs), max(xs)) == near(97, 803)
    marking = [x for x, _ in points(drawn[-1])]
    assert (min(marking), max(marking)) == near(100, 800)
    swallowed = replace(scene, roads=(straight(trim=(60.0, 40.0)),))
    assert roads(swallowed, ribbons, ["main"], PAGE) == ""


def test_the_name_of_a_road_stands_beyond_its_end() -> None:
    ribbon = straight_ribbon()
    assert written(labels.end_label(ribbon, [], FONT, "black")) == [
        ("main", *near_pair(1013, 253.5))
    ]
    assert written(labels.end_label(ribbon, [ribbon], FONT, "black"))[0][1] == pytest.approx(1026)
    elsewhere = straight_ribbon(y=22.9)
    assert written(labels.end_label(ribbon, [elsewhere], FONT, "black"))[0][1] == pytest.approx(
        1013
    )


def near_pair(x: float, y: float) -> tuple[object, object]:
    return pytest.approx(x, abs=0.02), pytest.approx(y, abs=0.02)


def test_names_are_needed_where_there_are_several_roads() -> None:
    assert labels.road_names([straight_ribbon()], FONT) == ""
    assert len(written(labels.road_names([straight_ribbon(), straight_ribbon(10.0)], FONT))) == 2


def test_an_original_is_outlined_and_its_middle_dashed() -> None:
    (outline,) = of(ghost.ghosts([straight_ribbon()]), "path")
    assert ends(outline) == near(0, 210, 0, 290)
    (line,) = of(ghost.ghost_lines([straight_ribbon()]), "path")
    assert ends(line) == near(0, 250, 1000, 250)
    assert line.get("stroke-dasharray") == outline.get("stroke-dasharray") == "5 3.5"
    (pale,) = of(ghost.context([straight_ribbon()]), "path")
    assert (pale.get("fill"), *ends(pale)) == (
        palette.CONTEXT,
        *[pytest.approx(v) for v in (0, 210, 0, 290)],
    )


def test_a_route_is_a_band_in_the_middle_of_the_streets() -> None:
    """0.6 of half the width of 40 px; at least 2 px."""
    (band,) = of(ghost.routes([straight_ribbon()], FONT), "path")
    assert (*ends(band), *numbers(band, "stroke-width")) == near(0, 250, 1000, 250, 24)
    (thin,) = of(ghost.routes([straight_ribbon(width=(0.4,) * 400)], FONT), "path")
    assert numbers(thin, "stroke-width") == [2]


def test_versions_are_outlines_and_dashed_lines_each_in_its_color() -> None:
    drawn = ghost.versions([straight_ribbon(), straight_ribbon(10.0)], FONT)
    assert [path.get("stroke") for path in of(drawn, "path")] == [
        color for color in palette.AGENTS[:2] for _ in range(2)
    ]
    assert [points(path)[0][1] for path in of(drawn, "path")] == list(near_pair(210, 250)) + list(
        near_pair(360, 400)
    )
    assert len(written(drawn)) == 2


def test_a_road_is_painted_in_layers() -> None:
    """The casing, round at its corners, then lanes beside, the surface, and what is on it."""
    lanes = (lane(1, "drive", 3.0, marking="solid"), lane(-1, "median", 1.0),
             lane(-2, "drive", 3.0), lane(-3, "sidewalk", 1.0))  # fmt: skip
    scene = replace(bend(), roads=(straight(**of_lanes(*lanes)),))
    drawn = roads(scene, {"main": ribbon_of(scene.roads[0], PAGE)}, ["main"], PAGE)
    layers = [
        {key: value for key, value in layer.attrib.items() if key != "font-size"}
        for layer in of(drawn, "g")
    ]
    assert layers == [
        {"class": "roads"},
        {"fill": palette.CASING, "stroke": palette.CASING, "stroke-linejoin": "round"},
        {"class": "lanes", "stroke": "none"},
        {"fill": palette.SURFACE, "stroke": "none"},
        {"class": "lanes", "stroke": "none"},
        {"class": "markings"},
    ]


def painted(drawn: str, tag: str, *names: str) -> list[list[str | None]]:
    return [[shape.get(name) for name in names] for shape in of(drawn, tag)]


def test_an_original_is_translucent_and_its_lines_are_dashed_in_blue() -> None:
    looks = ("fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width")
    assert painted(ghost.ghosts([straight_ribbon()]), "path", *looks) == [
        [palette.GHOST_FILL, "0.3", palette.GHOST_LINE, "0.75", "0.9"]
    ]
    assert painted(ghost.ghost_lines([straight_ribbon()]), "path", *looks) == [
        ["none", None, palette.GHOST_LINE, "0.85", "1.1"]
    ]


def test_versions_and_routes_are_translucent_in_the_colors_of_agents() -> None:
    looks = ("fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-dasharray")
    assert painted(ghost.versions([straight_ribbon()], FONT), "path", *looks) == [
        [palette.AGENTS[0], "0.3", palette.AGENTS[0], None, None],
        ["none", None, palette.AGENTS[0], None, "7 5"],
    ]
    assert painted(ghost.routes([straight_ribbon()], FONT), "path", *looks) == [
        ["none", None, palette.AGENTS[0], "0.55", None]
    ]
    assert painted(ghost.routes([straight_ribbon()], FONT), "path", "stroke-linecap") == [["round"]]


def test_names_on_the_map_have_a_halo_of_the_ground() -> None:
    halo = ("stroke", "paint-order", "text-anchor")
    assert painted(labels.end_label(straight_ribbon(), [], FONT, "red"), "text", *halo) == [
        [palette.GROUND, "stroke", "middle"]
    ]


@pytest.mark.parametrize(
    ("kinds", "between"),
    [
        (("sidewalk", "drive", "drive", "shoulder"), (1, 3)),
        (("drive",), (0, 1)),
        (("sidewalk", "bicycle"), (0, 2)),
    ],
)
def test_what_is_drivable_lies_between_two_borders(
    kinds: tuple[str, ...], between: tuple[int, int]
) -> None:
    lanes = [lane(-1 - k, kind, 3.0) for k, kind in enumerate(kinds)]
    assert straight_ribbon(**of_lanes(*lanes)).drivable == between
