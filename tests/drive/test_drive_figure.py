"""The figure of a drive by hand: 85.2 m across are 852 pixels between margins of 24."""

from __future__ import annotations

from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang.drive.figure import drive_figure
from roadlang.drive.robustness_colors import color_shares, robustness_color
from roadlang.geometry import Marking
from roadlang.ir.scene import SceneActor, SceneNetwork, SceneRoad
from roadlang.ir.scene_junctions import SceneArm, SceneJunction
from roadlang.ir.scene_lane import SceneLane
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.scenes.figure_colors import FIGURE_COLORS
from tests.backends.handmade_scenes import actor, bend, road

GREEN, YELLOW, RED = "#2f9e44", "#f59f00", "#c92a2a"


def moving(name: str, y: float = 0.0, width: float = 2.0) -> AgentTrace:
    """From x = 0 m to 80 m in 4 s."""
    time = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
    still = AgentTrace.standing(SceneActor(name, name, "car", 0.0, y, 0.0, 4.0, width, 1.5), time)
    return replace(still, x=20.0 * time)


def figure(robustness: Any = None, at: int | None = None, **changes: Any) -> ElementTree.Element:
    main = road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400)
    plain = {"roads": (main,), "objects": (actor("hut", "box", 40, 10, length=6.0, width=3.0),)}
    agents = {"ego": moving("ego"), "other": moving("other", y=-5.0)}
    trace = Trace(agents["ego"].time, agents)
    values = None if robustness is None else np.array(robustness, float)
    text = drive_figure(replace(bend(), **{**plain, **changes}), trace, "ego", values, "a < b", at)
    return ElementTree.fromstring(text.replace(' xmlns="http://www.w3.org/2000/svg"', ""))


def line(shape: ElementTree.Element) -> list[tuple[float, float]]:
    pairs = (pair.split(",") for pair in (shape.get("points") or "").split())
    return [(float(x), float(y)) for x, y in pairs]


def test_roads_and_paths_are_drawn_to_scale_with_y_up() -> None:
    """The highest point is the road at y = 0, 34 + 24 px from the top; y = -5 m is 50 px below."""
    root = figure()
    (main,) = root.findall("polygon")
    ego, other = root.findall("polyline")
    assert line(main) == [(24, 18), (876, 18), (876, 98), (24, 98)]
    assert ego.get("stroke-width") == "1.5"
    assert line(ego) == [(24 + 200 * i, 58) for i in range(5)]
    assert line(other)[0] == (24, 108)
    assert (root.get("width"), root.get("height")) == ("900", "152")
    assert [text.text for text in root.findall("text")] == ["a < b"]


@pytest.mark.parametrize("shown", ["roads", "agents", "nothing"])
def test_a_figure_is_of_what_it_shows_wherever_that_is(shown: str) -> None:
    far = road("main", lambda x: 500.0, 85.2, width=(8.0,) * 400)
    far = replace(far, x=tuple(1000.0 + value for value in far.x))
    ego = moving("ego", y=500.0)
    ego = replace(ego, x=1000.0 + ego.x)
    agents = {"ego": ego} if shown == "agents" else {}
    scene = replace(bend(), roads=(far,) if shown == "roads" else (), objects=(), agents=())
    text = drive_figure(scene, Trace(ego.time, agents), "ego", None, "far", None)
    root = ElementTree.fromstring(text.replace(' xmlns="http://www.w3.org/2000/svg"', ""))
    assert [line(part)[0] for part in root.findall("polygon")] == (
        [(24, 18)] if shown == "roads" else []
    )
    assert [line(part)[0] for part in root.findall("polyline")] == (
        [(24, 58)] if shown == "agents" else []
    )
    assert float(root.get("height") or 0) == 34 + 48 + 20


def test_a_road_is_as_wide_as_its_drivable_lanes_at_each_place() -> None:
    narrowing = tuple(np.linspace(8.0, 6.0, 400).tolist())
    (main,) = figure(roads=(road("main", lambda x: 0.0, 85.2, width=narrowing),)).findall("polygon")
    assert line(main) == [(24, 18), (876, 28), (876, 88), (24, 98)], "80 pixels wide, then 60"


def ring(**changes: Any) -> SceneRoad:
    """A circle around (0, 0) that begins and ends at (40, 0)."""
    around = np.linspace(0.0, 2.0 * np.pi, 401)[:-1]
    return replace(
        road("main", lambda x: 0.0, 80.0 * np.pi, width=(8.0,) * 400, **changes),
        x=tuple((40.0 * np.cos(around)).tolist()), y=tuple((40.0 * np.sin(around)).tolist()),
        heading=tuple((around + 0.5 * np.pi).tolist()), closed=True,
        stations=tuple((40.0 * around).tolist()),
    )  # fmt: skip


def test_a_closed_road_is_drawn_around_its_inside() -> None:
    (drawn,) = figure(roads=(ring(),)).findall("polygon")
    points = np.array(line(drawn))
    x, y = points.T
    area = 0.5 * abs(float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))))
    scale = (900 - 48) / 120.0  # from the west of the ring, at -40 m, to the end of the drive
    assert area == pytest.approx(2.0 * np.pi * 40.0 * 8.0 * scale**2, rel=0.01)


def test_lines_of_a_closed_road_that_leaves_a_junction_end_there() -> None:
    """6 m along the road from it, which they do not cross: nearly 12 m from each other."""
    paths = figure(roads=(ring(trim=(6.0, 6.0)),)).findall("path")
    lines = [part.split() for path in paths for part in (path.get("d") or "M").split("M")[1:]]
    scale = (900 - 48) / 120.0
    assert len(lines) == 3, "along both edges, and in the middle"
    for points in lines:
        (x, y), (end_x, end_y) = (map(float, points[i].split(",")) for i in (0, -1))
        assert x == pytest.approx(end_x, abs=0.2)
        assert abs(y - end_y) / scale == pytest.approx(12.0, abs=1.5)


def test_objects_are_drawn_in_their_size() -> None:
    hut = figure().findall("rect")[1]
    assert [hut.get(key) for key in ("x", "y", "width", "height")] == [
        "-30.0",
        "-15.0",
        "60.0",
        "30.0",
    ]
    assert hut.get("transform") == "translate(424.0 -42.0) rotate(-0.0)"


def test_the_path_has_the_color_of_its_robustness() -> None:
    """Above other paths: runs of one color, each up to the first point of the next; 0.35 of the
    agent's 2 m wide."""
    _, *runs = figure([1.0, 1.0, 0.0, -1.0, -2.0]).findall("polyline")
    assert [(run.get("stroke"), len(line(run))) for run in runs] == [
        (GREEN, 3), (YELLOW, 2), (RED, 2), (RED, 1)
    ]  # fmt: skip
    assert {run.get("stroke-width") for run in runs} == {"7.0"}


def test_the_path_of_a_thin_agent_can_be_seen() -> None:
    main = road("main", lambda x: 0.0, 8520.0)
    _, *runs = figure([1.0] * 5, roads=(main,)).findall("polyline")
    assert [run.get("stroke-width") for run in runs] == ["2.0"]


def test_the_moment_that_decides_is_marked() -> None:
    (mark,) = figure([1.0] * 5, at=2).findall("circle")
    assert (mark.get("cx"), mark.get("cy")) == ("424.0", "58.0")
    assert [title.text for title in mark] == ["ego at 2.0 s"]
    assert not figure([1.0] * 5).findall("circle")


def test_only_derived_roads_are_drawn_where_there_are_some() -> None:
    first = road("main", lambda x: 0.0, 85.2)
    second = replace(first, name="bent", derived=True)
    assert len(figure(roads=(first, second)).findall("polygon")) == 1


def test_shades_are_eighths_of_the_largest_of_a_sign() -> None:
    values = np.array([8.0, 4.0, 0.1, 0.0, np.nan, -0.1, -2.0, np.inf, -np.inf])
    assert color_shares(values).tolist() == [1, 0.5, 0.125, 0, 0, -0.125, -1, 1, -1]


@pytest.mark.parametrize(
    ("share", "color"), [(1.0, GREEN), (0.25, "#929e22"), (0.0, YELLOW), (-0.125, RED), (-1.0, RED)]
)
def test_the_color_is_green_yellow_or_red(share: float, color: str) -> None:
    """At a quarter halfway from yellow (245, 159, 0) to green (47, 158, 68)."""
    assert robustness_color(share) == color


def test_roads_end_where_junctions_begin() -> None:
    """The road from x = 0 m to 85.2 m reaches up to 5.2 m before its end, where the area begins."""
    main = road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400, trim=(0.0, 5.2))
    area = ((80.0, -4.0), (85.2, -4.0), (85.2, 0.0), (80.0, 0.0))
    place = SceneJunction(1, (1,), "junction", area, (SceneArm("main", "end", 5.2, 3, 0),), ())
    town = SceneNetwork("town", (), ("main",), junctions=(place,))
    root = figure(roads=(main,), networks=(town,))
    place_drawn, road_drawn = root.findall("polygon")
    assert max(x for x, _ in line(road_drawn)) == 824
    assert line(place_drawn) == [(824, 98), (876, 98), (876, 58), (824, 58)]


def test_who_has_left_is_drawn_no_further() -> None:
    present = np.array([1.0, 1.0, 1.0, 0.0, 0.0])
    agents = {
        "ego": replace(moving("ego"), present=present),
        "other": replace(moving("other", y=-5.0), present=present),
    }
    scene = replace(bend(), roads=(road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400),))
    values = np.array([1.0, 2.0, 3.0, 4.0, 5.0])
    text = drive_figure(scene, Trace(agents["ego"].time, agents), "ego", values, "a < b", 2)
    shapes = ElementTree.fromstring(text.replace(' xmlns="http://www.w3.org/2000/svg"', ""))
    paths = [line(shape) for shape in shapes.iter("polyline")]
    assert max(x for path in paths for x, _ in path) == pytest.approx(24 + 40.0 * 10, abs=1.0)


def test_an_agent_that_has_left_is_drawn_no_further() -> None:
    present = np.array([1.0, 1.0, 1.0, 0.0, 0.0])
    ego = replace(moving("ego"), present=present)
    shown = figure_of(ego)
    assert line(shown) == [(24 + 200 * i, 58) for i in range(3)]


def test_an_agent_that_was_never_there_is_drawn_where_it_would_have_been() -> None:
    ego = replace(moving("ego"), present=np.zeros(5))
    assert line(figure_of(ego)) == [(24 + 200 * i, 58) for i in range(5)]


def figure_of(ego: AgentTrace) -> ElementTree.Element:
    """The path of one agent on the road."""
    main = road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400)
    scene = replace(bend(), roads=(main,), objects=())
    text = drive_figure(scene, Trace(ego.time, {"ego": ego}), "ego", None, "a < b", None)
    root = ElementTree.fromstring(text.replace(' xmlns="http://www.w3.org/2000/svg"', ""))
    return root.findall("polyline")[0]


def test_places_that_are_half_known_are_not_drawn() -> None:
    lost = replace(moving("ego"), y=np.array([0.0, 0.0, np.nan, 0.0, np.nan]))
    assert line(figure_of(lost)) == [(24 + 200 * i, 58) for i in (0, 1, 3)]


def test_of_a_road_that_lies_within_junctions_nothing_is_drawn() -> None:
    inside = road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400, trim=(42.6, 42.6))
    assert figure(roads=(inside,)).findall("polygon") == []


def marked(marking: Marking, edges: Marking = "none", **changes: Any) -> list[ElementTree.Element]:
    """The lines of a figure of two lanes of 4 m, 40 pixels each."""
    lanes = tuple(
        SceneLane(id, "drive", "backward" if id > 0 else "forward", (4.0,), marking=edges)
        for id in (1, -1)
    )
    main = road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400)
    main = replace(main, lanes=2, lane_list=lanes, center_marking=marking, **changes)
    return figure(roads=(main,)).findall("path")


def test_lines_between_lanes_are_drawn_as_they_are_marked() -> None:
    """Broken or double in the middle, at y = 0; each line of a double one is 1.2 lines away."""
    (broken,), (double,) = marked("broken"), marked("double")
    assert broken.get("d") == "M24.0,58.0 876.0,58.0", "two points of a straight line"
    assert broken.get("stroke-dasharray") == "30.0 60.0"
    assert double.get("d") == "M24.0,56.3 876.0,56.3M24.0,59.7 876.0,59.7"
    assert double.get("stroke-dasharray") is None
    assert marked("none") == []


def test_edge_lines_are_drawn_inside_the_road_and_curbs_in_their_own_color() -> None:
    """The road is from y = 18 to 98 pixels: a line 2.5 inside each edge, a curb on the edge."""
    (solid,), (curb,) = marked("none", "solid"), marked("none", "curb")
    assert solid.get("d") == "M24.0,20.5 876.0,20.5M24.0,95.5 876.0,95.5"
    assert curb.get("d") == "M24.0,18.0 876.0,18.0M24.0,98.0 876.0,98.0"
    assert solid.get("stroke") != curb.get("stroke")


def test_lines_end_where_junctions_begin() -> None:
    """10 m after the start and 5.2 m before the end, at 10 pixels per meter."""
    (line,) = marked("solid", trim=(10.0, 5.2))
    assert line.get("d") == "M124.0,58.0 824.0,58.0"


def test_lines_of_lanes_too_narrow_to_see_are_left_out() -> None:
    long = replace(road("main", lambda x: 0.0, 852.0, width=(8.0,) * 400), lanes=2)
    assert len(figure(roads=(long,)).findall("path")) == 2, "along the edges, and in the middle"
    longer = replace(road("main", lambda x: 0.0, 8520.0, width=(8.0,) * 400), lanes=2)
    assert figure(roads=(longer,)).findall("path") == []


def test_sidewalks_and_what_is_beside_the_roadway_have_colors_of_their_own() -> None:
    straight = road("main", lambda x: 0.0, 85.2, width=(4.0,) * 400)
    lanes = (
        SceneLane(1, "drive", "backward", (2.0,)),
        SceneLane(-1, "drive", "forward", (2.0,)),
        SceneLane(-2, "parking", "forward", (2.0,), drivable=False),
        SceneLane(-3, "sidewalk", "none", (1.0,), drivable=False, raised=True),
    )
    drawn = figure(roads=(replace(straight, lanes=2, lane_list=lanes),)).findall("polygon")
    tops = [(area.get("fill"), sorted({y for _, y in line(area)})) for area in drawn]
    middle = 58.0
    assert tops == [
        (FIGURE_COLORS.beside, [middle + 20, middle + 40]),
        (FIGURE_COLORS.raised, [middle + 40, middle + 50]),
        (FIGURE_COLORS.surface, [middle - 20, middle + 20]),
    ]


def test_crowns_are_round_and_roofs_are_not() -> None:
    house = replace(actor("house", "building", 40, 10, length=6.0, width=3.0), category="building")
    tree = replace(house, name="oak", category="tree", length=4.0, width=4.0)
    root = figure(objects=(tree, house))
    (crown,) = root.findall("circle")
    assert (crown.get("r"), crown.get("fill")) == ("20.0", FIGURE_COLORS.leaves)
    assert root.findall("rect")[1].get("fill") == FIGURE_COLORS.roof


def test_crossings_are_painted_where_a_scene_has_them() -> None:
    main = road("main", lambda x: 0.0, 85.2, width=(8.0,) * 400)
    crossing = actor("zebra", "crosswalk", 40, 0, length=4.0, width=8.0)
    plain, painted = (figure(roads=(main,), markings=m) for m in ((), (crossing,)))
    stripes = [path for path in painted.findall("path") if path.get("fill") != "none"]
    assert [path.get("fill") for path in stripes] == [FIGURE_COLORS.marking]
    assert len(painted.findall("path")) == len(plain.findall("path")) + 1
