"""The page of a figure by hand: title, legend, plots over arc length, the sheet of many scenes."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import pytest

from roadlang.ir.scene import Profile, RoadPlace, Scene, SceneSignal, Verdict
from roadlang_standard.svg import palette, profiles
from roadlang_standard.svg.drawing import Style, draw
from roadlang_standard.svg.legend import legend_of
from roadlang_standard.svg.selection import select
from roadlang_standard.svg.sheet import contact_sheet
from tests.backends.handmade_scenes import bend, road, town
from tests.backends.svg_shapes import (
    Shape,
    numbers,
    of,
    points,
    straight,
    written,
)

FONT = 10.0
RHO = "\N{GREEK SMALL LETTER RHO} = "


def near(*values: float) -> object:
    return pytest.approx(values, abs=0.02)


def only(*roads: Any, **changes: Any) -> Scene:
    plain = {"agents": (), "objects": (), "requirements": (), "expectations": ()}
    return replace(bend(), roads=roads, **{**plain, **changes})


def page(scene: Scene, **style: Any) -> Shape:
    """A figure 780 pixels wide, which has letters of 10 and a margin of 12 pixels."""
    return ElementTree.fromstring(draw(scene, Style(size=780.0, **style)))


def named(root: Shape, tag: str) -> list[Shape]:
    return list(root.iter(f"{{http://www.w3.org/2000/svg}}{tag}"))


def texts(root: Shape) -> dict[str, tuple[float, float]]:
    found = {}
    for node in named(root, "text"):
        x, y = numbers(node, "x", "y")
        found[node.text or ""] = (x, y)
    return found


def short(**changes: Any) -> Any:
    """60 m eastward, 7.5 m wide: with its margins 75.6 m, 10 pixels a meter of 756 pixels."""
    return road("main", lambda x: 0.0, 60.0, width=(7.5,) * 400, **changes)


def test_a_page_is_title_map_and_foot_from_top_to_bottom() -> None:
    """12 px margin, 23 px title, a map of 756 x 236.25 px, 9 px, 26 px of scale, 12 px margin."""
    root = page(only(short()))
    assert numbers(root, "width", "height") == [780, 318]
    ground = named(root, "rect")[2]
    assert numbers(ground, "x", "y", "width", "height") == near(12, 35, 756, 236.25)
    scale = named(root, "rect")[-3:]
    assert numbers(scale[2], "x", "y", "width") == near(746 - 100, 271.25 + 12, 100)
    shown = texts(root)
    assert shown["N"] == near(768 - 19, 35 + 34 - 15 - 3.5)
    assert shown["A bend from an aerial photo, bent further"] == near(12, 24)
    assert shown["paper · scene 0 · seed 7"] == near(768, 24)


def test_a_legend_and_plots_make_a_page_longer() -> None:
    """A requirement takes 12.5 + 3 px, less than the scale; three take 46.5 px.
    A plot takes 31 px and the axis 24 px, 8 px below the legend."""
    (phi, _) = bend().requirements
    plotted = replace(phi, profiles=(Profile("main", (0.0, 60.0), (4.0, 4.0)),),
                      tightest=RoadPlace("main", 0.0))  # fmt: skip
    heights = {
        count: numbers(page(only(short(), requirements=(phi,) * count)), "height")[0]
        for count in (1, 3)
    }
    assert heights == {1: 318, 3: pytest.approx(318.25 + 46.5 - 26, abs=0.5)}
    assert numbers(page(only(short(), requirements=(plotted,))), "height")[0] == pytest.approx(
        318.25 + 8 + 31 + 24, abs=0.5
    )


def test_a_small_figure_has_letters_of_7_pixels() -> None:
    assert (Style(size=200.0).font, Style(size=780.0).font) == (7.0, 10.0)


def test_a_title_that_is_too_long_is_cut_before_the_note() -> None:
    """780 px less margins are 120 letters of 6.2 px, of which the note takes 24."""
    for length, shown in ((96, "x" * 96), (97, "x" * 95 + "…")):
        assert shown in texts(page(replace(only(short()), title="x" * length)))
    assert "paper" in texts(page(replace(only(short()), title="")))


def test_a_scene_without_title_is_described_by_its_name() -> None:
    root = page(replace(only(short()), title=""))
    assert named(root, "title")[0].text == "paper: scene 0, seed 7"


def colored(*verdicts: Verdict) -> Any:
    return legend_of(only(requirements=verdicts), 400.0, FONT)


def test_a_row_of_the_legend_is_mark_name_formula_and_outcome() -> None:
    """The name begins 19 px from the left, the formula 29 px + 7.2 px a letter of the name."""
    satisfied = replace(bend().requirements[0], name="phi1", text="always (e < 1m)")
    drawn = colored(satisfied).drawn(100.0, 50.0)
    assert written(drawn) == [
        ("phi1", 119, 60), ("always (e < 1m)", pytest.approx(157.8), 60), (f"{RHO}4", 500, 60)
    ]  # fmt: skip
    (tick,) = of(drawn, "polyline")
    assert tick.get("stroke") == palette.SATISFIED
    assert points(tick) == [(102.4, 56.6), (105.1, 59.3), (109.6, 53.72)]


def test_marks_tell_satisfied_violated_and_not_yet_driven_apart() -> None:
    calm, lane = bend().expectations
    drawn = colored(calm, lane).drawn(0.0, 0.0)
    (cross,), (ring,) = of(drawn, "polyline"), of(drawn, "circle")
    assert points(cross) == [(2.4, 3.0), (9.6, 10.2), (6.0, 6.6), (2.4, 10.2), (9.6, 3.0)]
    assert cross.get("stroke") == palette.VIOLATIONS[0]
    assert numbers(ring, "cx", "cy", "r") == near(6, 22.1, 2.7)
    assert ring.get("stroke") == palette.UNKNOWN
    outcomes = [text for text, x, _ in written(drawn) if x == 400]
    assert outcomes == [f"{RHO}\N{MINUS SIGN}0.0113", "when driven"]


def test_a_violation_without_robustness_is_marked_all_the_same() -> None:
    seen = replace(bend().expectations[0], robustness=None)
    drawn = colored(seen).drawn(0.0, 0.0)
    assert len(of(drawn, "polyline")) == 1
    assert [text for text, x, _ in written(drawn) if x == 400] == [""]


def test_the_rows_of_a_legend_follow_each_other() -> None:
    """A line takes 12.5 px, and 3 px are between rows."""
    first = replace(bend().requirements[0], name="a", text="x " * 60)
    legend = colored(first, replace(first, name="b", text="y"))
    lines = {text: y for text, _, y in written(legend.drawn(0.0, 0.0))}
    # 400 - 35.2 - 75 px hold 54 letters: 27 of the 60 words in each line.
    assert [y for text, _, y in written(legend.drawn(0.0, 0.0)) if text.startswith("x")] == near(
        10, 22.5, 35
    )
    assert lines["y"] == pytest.approx(10 + 3 * 12.5 + 3)
    assert legend.height == pytest.approx(4 * 12.5 + 2 * 3)


def test_a_long_name_is_cut_in_the_legend() -> None:
    for length, shown in ((22, "n" * 22), (23, "n" * 21 + "…")):
        rows = written(colored(replace(bend().requirements[0], name="n" * length)).drawn(0, 0))
        assert rows[0][0] == shown
        assert rows[1][1] == pytest.approx(29 + 7.2 * 22)


STATIONS = (0.0, 25.0, 50.0, 75.0, 100.0)


def plot(values: tuple[float, ...], name: str = "e1", place: float = 50.0, **options: Any) -> Any:
    return profiles.ProfileRow(name, "note", Profile("main", STATIONS, values), place, **options)


def drawn(*rows: Any) -> str:
    """Plots from (0, 0), 462 px wide: 400 px for 100 m beside 62 px of names."""
    return profiles.profiles(rows, 0.0, 0.0, 462.0, FONT)


def test_a_plot_runs_from_its_greatest_value_down_to_its_least() -> None:
    """A plot is 21 px high and begins 5 px down: 3 is at 5, -4 at 26, 0 at 14."""
    curve = of(drawn(plot((0.0, 3.0, 0.0, -4.0, 0.0), signal=True)), "path")[0]
    assert [v for pair in points(curve) for v in pair] == pytest.approx(
        [62, 14, 162, 5, 262, 14, 362, 26, 462, 14]
    )
    assert curve.get("stroke") == palette.AGENTS[0]


def test_a_plot_reaches_to_zero() -> None:
    up, down = (of(drawn(plot((v,) * 5, signal=True)), "path")[0] for v in (2.0, -2.0))
    assert (points(up)[0][1], points(down)[0][1]) == (5, 26)
    zero = [
        numbers(of(drawn(plot((v,) * 5)), "line")[0], "x1", "y1", "x2", "y2") for v in (2.0, -2.0)
    ]
    assert zero == [[62, 26, 462, 26], [62, 5, 462, 5]]


def test_the_area_of_a_robustness_reaches_down_to_zero() -> None:
    area = of(drawn(plot((2.0, 1.0, 2.0, 2.0, 2.0))), "path")[0]
    assert [v for pair in points(area) for v in pair] == pytest.approx(
        [62, 26, 62, 5, 162, 15.5, 262, 5, 362, 5, 462, 5, 462, 26]
    )


@pytest.mark.parametrize(("place", "x"), [(50.0, 262), (60.0, 262), (63.0, 362), (999.0, 462)])
def test_a_dot_marks_the_extreme(place: float, x: float) -> None:
    (dot,) = of(drawn(plot((2.0, 1.0, 2.0, 2.0, 2.0), place=place)), "circle")
    assert numbers(dot, "cx", "r") == [x, 2.2]
    assert dot.get("fill") == palette.TIGHT


def test_plots_stand_below_each_other_over_one_arc_length() -> None:
    """31 px each; the axis 2 px below the last has a tick each 20 m, and its name at the end."""
    figure = drawn(plot((1.0,) * 5), plot((1.0,) * 5, name="e2"))
    curves = [p for p in of(figure, "path") if p.get("fill") == "none"]
    assert [points(curve)[0][1] for curve in curves] == [5, 36]
    lines = [numbers(line, "x1", "y1", "x2", "y2") for line in of(figure, "line")[2:]]
    assert lines[0] == [62, 64, 462, 64]
    assert lines[1:] == [[62 + 80 * i, 64, 62 + 80 * i, 67] for i in range(6)]
    axis = [entry for entry in written(figure) if entry[2] == 76.5]
    assert axis == [("0 m", 62, 76.5), ("20", 142, 76.5), ("40", 222, 76.5), ("60", 302, 76.5),
                    ("80", 382, 76.5), ("arc length", 462, 76.5)]  # fmt: skip
    names = [entry for entry in written(figure) if entry[0] in ("e1", "e2", "note")]
    assert [y for _, _, y in names] == near(13.02, 24.02, 44.02, 55.02)
    assert profiles.height([plot((1.0,) * 5)] * 2, FONT) == 86


def test_long_names_leave_less_room_for_plots_within_limits() -> None:
    for length, left in ((3, 62), (15, 93), (40, 136.4)):
        line = of(drawn(plot((1.0,) * 5, name="n" * length)), "line")[0]
        assert numbers(line, "x1") == near(left)


def test_a_plot_of_many_points_keeps_its_extremes() -> None:
    count = 5000
    values = [1.0] * count
    values[1234], values[4321] = 9.0, -9.0
    stations = tuple(100.0 * i / (count - 1) for i in range(count))
    row = profiles.ProfileRow("e", "", Profile("main", stations, tuple(values)), 0.0, signal=True)
    curve = points(of(drawn(row), "path")[0])
    assert len(curve) <= 1202
    assert (min(y for _, y in curve), max(y for _, y in curve)) == (5, 26)
    assert (curve[0][0], curve[-1][0]) == (62, 462)
    assert [x for x, _ in curve] == sorted(x for x, _ in curve)


def test_up_to_8_plots_signals_first() -> None:
    e = SceneSignal("e", "", "", (Profile("main", STATIONS, (1.0,) * 5),))
    phi = replace(bend().requirements[0], profiles=e.profiles, tightest=RoadPlace("main", 0.0))
    rows = profiles.rows_of(only(straight(), signals=(e,) * 3, requirements=(phi,) * 9))
    assert [row.name for row in rows] == ["e"] * 3 + ["phi1"] * 5
    assert (rows[0].note, rows[3].note) == ("up to 1", f"{RHO}4")


def sheet(count: int, size: float = 900.0, **changes: Any) -> Shape:
    scenes = [replace(only(short()), index=i, **changes) for i in range(count)]
    text = contact_sheet(scenes, size)
    assert text is not None
    return ElementTree.fromstring(text)


@pytest.mark.parametrize(("count", "columns"), [(2, 1), (3, 1), (4, 2), (9, 2), (16, 3), (48, 6)])
def test_the_cells_of_a_sheet_make_it_about_as_wide_as_tall(count: int, columns: int) -> None:
    """Cells are 0.35 as tall as wide here, and with their captions half."""
    captions = texts(sheet(count))
    xs = {captions[f"scene {i}"][0] for i in range(count)}
    assert len(xs) == columns


def test_cells_have_a_gap_of_14_pixels_between_them() -> None:
    """Four cells in two columns of (900 - 3 x 14) / 2 px, 0.35 as tall, 32 px below the top.

    Below each are 28 px for its number and a line for its draws.
    """
    root = sheet(4)
    frames = [numbers(box, "x", "y", "width", "height") for box in named(root, "rect")
              if box.get("fill") == "none"]  # fmt: skip
    row = 150.15 + 28 + 14
    assert frames == [near(x, 32 + y, 429, 150.15) for y in (0, row) for x in (14, 457)]
    assert texts(root)["scene 0"] == near(14, 32 + 150.15 + 13.5)
    assert numbers(root, "height") == near(round(32 + 2 * row))
    assert texts(root)["A bend from an aerial photo, bent further: 4 scenes, seed 7"] == near(
        14, 19
    )


def test_the_caption_of_a_cell_is_its_nearest_miss_in_small_lines() -> None:
    phi = bend().requirements
    root = sheet(2, requirements=phi)
    (first, *_) = [numbers(t, "x", "y", "font-size") for t in named(root, "text")
                   if t.text == f"phi3: {RHO}0.25"]  # fmt: skip
    captions = texts(root)
    assert first == near(14, captions["scene 0"][1] + 12, 8.5)


def test_the_draws_below_a_cell_take_at_most_three_lines() -> None:
    def scene(index: int) -> Scene:
        draws = {f"main/perturb 1/a_rather_long_name_{i}": index + i / 8 for i in range(40)}
        return replace(only(short()), index=index, draws=draws)

    text = contact_sheet([scene(0), scene(1)], 300.0)
    assert text is not None
    lines = re.findall(r">(a_rather[^<]*)<", text)
    assert len(lines) == 6
    assert lines[0].startswith("a_rather_long_name_0 0,")


def test_derived_roads_are_drawn_in_full_and_what_they_were_as_ghosts() -> None:
    changed = replace(straight(y=30.0), name="bent", root="main", derived=True)
    selection = select(only(straight(), changed))
    assert (selection.full, selection.ghosts, selection.versions) == (("bent",), ("main",), ())
    assert selection.measured == ("bent",)


def test_several_versions_of_a_road_share_the_marks_of_the_first() -> None:
    both = [replace(straight(y=y), name=f"v{y}", root="main", derived=True) for y in (30.0, 20.0)]
    selection = select(only(straight(), *both))
    assert (selection.full, selection.versions) == ((), ("v30.0", "v20.0"))
    assert selection.measured == ("v30.0",)


def test_streets_under_a_drawn_road_are_no_context() -> None:
    """A road taken out of a network: the other streets are pale, those beneath it are not drawn."""
    scene = town()
    streets = [replace(street, derived=False) for street in scene.roads]
    tour = replace(streets[2], name="tour", root="tour", network=None, edge=None, derived=True)
    selection = select(replace(scene, roads=(*streets, tour)))
    assert selection.full == ("tour",)
    assert selection.context == ("town/1", "town/2", "town/4", "town/5", "town/6")


@pytest.mark.parametrize(("aside", "is_route"), [(0.0, True), (1.5, True), (2.5, False)])
def test_a_route_keeps_within_a_step_of_its_streets(aside: float, is_route: bool) -> None:
    """Streets with a point each meter: 1.5 m and half a meter may lie between."""
    street = road("town/1", lambda x: 0.0, 399.0, network="town", edge=1, derived=True)
    tour = road("tour", lambda x: aside, 399.0, derived=True)
    assert (select(only(street, tour)).routes == ("tour",)) == is_route
