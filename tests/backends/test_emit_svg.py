"""`emit svg`: a figure that shows what the scene holds, at every size."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang.api import Picture
from roadlang.ir.scene import Profile, RoadPlace, Scene, SceneSignal
from roadlang_standard.emit_svg import Svg
from tests.backends.handmade_scenes import actor, bend, road, town

SVG = "{http://www.w3.org/2000/svg}"


def drawn(scene: Any, **options: Any) -> ElementTree.Element:
    return ElementTree.fromstring(Svg(**options).files(scene)["svg"])


def found(root: ElementTree.Element, name: str) -> ElementTree.Element | None:
    """The group of a class, if there is one."""
    return next((g for g in root.iter(f"{SVG}g") if g.get("class") == name), None)


def group(root: ElementTree.Element, name: str) -> ElementTree.Element:
    element = found(root, name)
    assert element is not None, f"no group of class {name}"
    return element


def child(element: ElementTree.Element, name: str) -> ElementTree.Element:
    node = element.find(name)
    assert node is not None, f"no {name}"
    return node


def attribute(element: ElementTree.Element, name: str) -> str:
    value = element.get(name)
    assert value is not None, f"no attribute {name}"
    return value


def texts(root: ElementTree.Element) -> list[str]:
    return ["".join(node.itertext()) for node in root.iter(f"{SVG}text")]


def test_a_figure_has_road_markings_ghost_agents_objects_scale_and_north() -> None:
    root = drawn(bend())
    for name in ("roads", "markings", "ghosts", "agents", "objects", "scale-bar", "north"):
        assert found(root, name) is not None, name


def test_the_size_option_is_the_width_in_pixels() -> None:
    assert drawn(bend(), size=640.0).get("width") == "640"


@pytest.mark.parametrize("scale", [0.2, 1.0, 20.0])
def test_letters_have_one_size_whatever_the_scene_measures(scale: float) -> None:
    legend = group(drawn(bend(scale)), "legend")
    assert legend is not None
    assert float(attribute(legend, "font-size")) == pytest.approx(1024 / 78, abs=0.01)


@pytest.mark.parametrize("scale", [0.2, 1.0, 20.0])
def test_every_point_of_the_roads_lies_in_the_map(scale: float) -> None:
    root = drawn(bend(scale))
    _, _, width, height = map(float, attribute(root, "viewBox").split())
    roads = group(root, "roads")
    for path in roads.iter(f"{SVG}path"):
        for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", attribute(path, "d")):
            assert 0 <= float(x) <= width
            assert 0 <= float(y) <= height


@pytest.mark.parametrize(("scale", "label"), [(0.2, "10 m"), (1.0, "20 m"), (20.0, "500 m")])
def test_the_scale_bar_has_a_round_length(scale: float, label: str) -> None:
    root = drawn(bend(scale))
    bar = group(root, "scale-bar")
    value, unit = texts(bar)[-1].split()
    meters = float(value) * (1000 if unit == "km" else 1)
    assert texts(bar)[-1] == label
    original = re.findall(r"(-?[\d.]+) -?[\d.]+", attribute(group(root, "ghost-lines")[0], "d"))
    pixels_per_meter = (float(original[-1]) - float(original[0])) / (240.0 * scale)
    length = float(attribute(bar.findall(f"{SVG}rect")[2], "width"))
    assert length == pytest.approx(meters * pixels_per_meter, rel=0.01)


def test_violated_stretches_are_marked_where_they_are() -> None:
    scene = bend()
    marks = group(drawn(scene), "violations")
    titles = [node.text for node in marks.iter(f"{SVG}title")]
    assert titles == ["calm violated: 30.0 m to 62.0 m", "calm violated: 150.0 m to 171.0 m"]
    assert found(drawn(replace(scene, expectations=())), "violations") is None


def test_the_legend_says_how_each_requirement_came_out() -> None:
    words = texts(group(drawn(bend()), "legend"))
    assert "phi1" in words
    assert "\N{GREEK SMALL LETTER RHO} = 4" in words
    assert "when driven" in words


def test_a_ghost_is_drawn_only_where_the_road_was_changed() -> None:
    scene = bend()
    assert found(drawn(scene, ghost=False), "ghosts") is None
    unchanged = replace(scene.roads[0], name="bent", root="main", derived=True)
    same = replace(scene, roads=(scene.roads[0], unchanged))
    assert found(drawn(same), "ghosts") is None


def test_a_long_formula_is_written_whole_in_several_lines() -> None:
    scene = bend()
    shown = " ".join(texts(group(drawn(scene), "legend")))
    assert scene.requirements[1].text in shown
    long = replace(scene.requirements[1], text="always (e < 1m) and " * 40 + "e < 2m")
    words = texts(
        group(drawn(replace(scene, requirements=(long,), expectations=()), size=300.0), "legend")
    )
    assert " ".join(words).count("always") == 40


def test_signals_and_robustness_are_plotted_over_arc_length() -> None:
    stations = tuple(float(s) for s in range(0, 240, 2))
    e1 = SceneSignal("e1", "deviation(bent, main)", "m", (
        Profile("bent", stations, tuple(s / 60 for s in stations)),))  # fmt: skip
    left = tuple(4.0 - s / 60 for s in stations)
    phi1 = replace(
        bend().requirements[0],
        profiles=(Profile("bent", stations, left),),
        tightest=RoadPlace("bent", 238.0),
    )
    root = drawn(replace(bend(), signals=(e1,), requirements=(phi1,)))
    shown = texts(group(root, "profiles"))
    assert {"e1", "up to 3.97 m", "phi1", "arc length"} <= set(shown)
    assert texts(group(root, "tightest")) == ["phi1"]
    assert found(drawn(bend(), profiles=True), "profiles") is None
    assert found(drawn(replace(bend(), signals=(e1,)), profiles=False), "profiles") is None


def test_the_place_where_a_constraint_is_tight_is_marked_on_the_road() -> None:
    scene = bend()
    at = scene.roads[1].stations[200]
    phi1 = replace(scene.requirements[0], tightest=RoadPlace("bent", at))
    pin = group(drawn(replace(scene, requirements=(phi1,))), "tightest")
    foot = child(pin, f".//{SVG}circle")
    center = re.findall(
        r"(-?[\d.]+) (-?[\d.]+)", attribute(group(drawn(scene), "ghost-lines")[0], "d")
    )
    middle = center[len(center) // 2]
    assert abs(float(attribute(foot, "cx")) - float(middle[0])) < 40


def test_the_world_is_said_in_a_corner() -> None:
    world = {"weather": "rain", "time_of_day": 66600.0, "friction": 0.7}
    assert "rain · 18:30 · friction 0.70" in texts(drawn(replace(bend(), world=world)))


def test_the_photo_lies_under_the_roads_where_it_was_taken() -> None:
    pixels = np.full((120, 480, 3), 90, np.uint8)
    scene = bend()
    root = drawn(scene, photo=Picture(pixels, 0.5), fade=0.5)
    picture = child(root, f".//{SVG}image")
    bar = group(root, "scale-bar")
    meters = float(texts(bar)[-1].split()[0])
    per_meter = float(attribute(bar.findall(f"{SVG}rect")[2], "width")) / meters
    assert float(attribute(picture, "width")) == pytest.approx(240 * per_meter, rel=0.01)
    assert picture.get("opacity") == "0.5"


def test_junctions_are_covered_so_that_no_edge_line_crosses_them() -> None:
    roads = group(drawn(town()), "roads")
    surface = roads.findall(f"{SVG}g")[1]
    assert len(surface.findall(f"{SVG}circle")) == 2


def test_agents_stay_visible_in_a_scene_of_five_kilometers() -> None:
    body = child(group(drawn(bend(20.0)), "agents"), f".//{SVG}rect")
    assert float(attribute(body, "width")) >= 15.0


def test_a_group_of_many_has_one_label() -> None:
    cars = tuple(actor(f"parked[{i}]", "car", 20.0 * i, 0, group="parked") for i in range(9))
    labels = texts(group(drawn(replace(bend(), agents=cars)), "labels"))
    assert "parked (9)" in labels
    assert not any("[" in label for label in labels)
    few = texts(group(drawn(replace(bend(), agents=cars[:2])), "labels"))
    assert {"parked[0]", "parked[1]"} <= set(few)


def test_names_that_look_like_markup_are_text() -> None:
    scene = replace(bend(), title='<script>alert("1")</script> & more\x07')
    assert '<script>alert("1")</script> & more' in texts(drawn(scene))


def test_a_kind_without_a_drawing_of_its_own_is_drawn_as_its_outline() -> None:
    scene = replace(bend(), objects=(actor("hole", "acme.pothole", 20, 0),))
    assert child(group(drawn(scene), "objects"), f".//{SVG}rect") is not None


def test_a_color_is_a_color_and_nothing_else() -> None:
    scene = replace(bend(), agents=(actor("ego", "car", 0, 0, options={"color": "url(#x)"}),))
    assert "url(#x)" not in Svg().files(scene)["svg"]


def test_an_empty_scene_is_a_figure_too() -> None:
    scene = replace(bend(), roads=(), agents=(), objects=(), requirements=(), expectations=())
    assert found(drawn(scene), "scale-bar") is not None


def test_a_closed_road_is_closed() -> None:
    import math

    points = [
        (50 * math.cos(2 * math.pi * i / 90), 50 * math.sin(2 * math.pi * i / 90))
        for i in range(90)
    ]
    from tests.backends.handmade_scenes import through

    ring = through("ring", points, closed=True, length=2 * math.pi * 50, derived=True)
    scene = replace(bend(), roads=(ring,), agents=(), expectations=())
    marking = attribute(child(group(drawn(scene), "markings"), f"{SVG}path"), "d")
    numbers = re.findall(r"-?[\d.]+ -?[\d.]+", marking)
    assert numbers[0] == numbers[-1]


def test_the_same_scene_gives_the_same_bytes() -> None:
    assert Svg().files(bend())["svg"] == Svg().files(bend())["svg"]


def test_a_contact_sheet_shows_every_scene_at_one_scale() -> None:
    scenes = [bend(index=i, amplitude=float(i)) for i in range(7)]
    sheet = Svg().collection(scenes)["contact-sheet.svg"]
    root = ElementTree.fromstring(sheet)
    words = texts(root)
    assert [f"scene {i}" for i in range(7)] == [
        word for word in words if re.match(r"scene \d", word)
    ]


def test_a_contact_sheet_shows_the_draws_that_differ() -> None:
    def scene(index: int) -> Scene:
        draws = {"bent/perturb 1/amplitude": 1.5 + index, "bent/perturb 1/phase": 0.25}
        units = {"bent/perturb 1/amplitude": "m", "bent/perturb 1/phase": "rad"}
        return replace(bend(index=index), draws=draws, units=units)

    sheet = Svg().collection([scene(i) for i in range(3)])["contact-sheet.svg"]
    shown = texts(ElementTree.fromstring(sheet))
    assert [word for word in shown if "amplitude" in word] == [
        f"amplitude {1.5 + i:g} m" for i in range(3)
    ]
    assert not any("phase" in word for word in shown)


def test_draws_of_one_name_are_told_apart_by_their_place() -> None:
    def scene(index: int) -> Scene:
        draws = {"left/amplitude": 1.0 + index, "right/amplitude": 2.0 + index}
        return replace(bend(index=index), draws=draws)

    sheet = Svg(size=2048.0).collection([scene(i) for i in range(2)])["contact-sheet.svg"]
    assert "left/amplitude" in sheet
    assert "right/amplitude" in sheet


def test_a_contact_sheet_says_how_many_scenes_it_leaves_out() -> None:
    sheet = Svg().collection(bend(index=i) for i in range(60))["contact-sheet.svg"]
    assert "the first 48 of 60 scenes" in sheet


def test_one_scene_needs_no_contact_sheet() -> None:
    assert Svg().collection([bend()]) == {}


def test_a_road_of_two_points_is_drawn() -> None:
    line = road("line", lambda x: 0.0, derived=True)
    columns = ("stations", "reference_stations", "x", "y", "heading", "curvature", "width")
    ends: dict[str, Any] = {
        name: (getattr(line, name)[0], getattr(line, name)[-1]) for name in columns
    }
    short = replace(line, **ends)
    assert found(drawn(replace(bend(), roads=(short,), expectations=())), "roads") is not None


def test_versions_of_one_road_are_told_apart_by_color_and_name() -> None:
    scene = bend()
    other = replace(scene.roads[1], name="right")
    root = drawn(replace(scene, roads=(*scene.roads, other), expectations=()))
    assert texts(group(root, "versions")) == ["bent", "right"]


def test_a_road_that_runs_on_a_network_is_a_route_on_its_streets() -> None:
    scene = town()
    street = next(r for r in scene.roads if r.name == "town/3")
    tour = replace(street, name="tour", root="tour", network=None, edge=None)
    root = drawn(replace(scene, roads=(*scene.roads, tour)))
    assert len(group(root, "routes").findall(f"{SVG}path")) == 1
    assert texts(group(root, "routes")) == ["tour"]


@pytest.mark.parametrize(
    ("seconds", "shown"),
    [(0.0, "00:00"), (86_400.0, "00:00"), (86_370.0, "00:00"), (3_599.0, "01:00")],
)
def test_a_time_of_day_is_shown_in_hours_and_minutes(seconds: float, shown: str) -> None:
    assert shown in texts(drawn(replace(bend(), world={"time_of_day": seconds})))


@pytest.mark.parametrize(("count", "more"), [(14, None), (15, "and 1 more"), (40, "and 26 more")])
def test_a_legend_says_how_many_requirements_it_leaves_out(count: int, more: str | None) -> None:
    scene = bend()
    many = tuple(replace(scene.requirements[0], name=f"r{index}") for index in range(count))
    scene = replace(scene, requirements=many, expectations=())
    written = texts(group(drawn(scene), "legend"))
    assert [text for text in written if text.endswith(" more")] == ([more] if more else [])
    assert sum(bool(re.fullmatch(r"r\d+", text)) for text in written) == min(count, 14)


def poses(root: ElementTree.Element, name: str) -> list[tuple[float, float, float]]:
    """Where the things of a class are drawn (x, y), and by how much they are turned, clockwise."""
    shapes = (g.get("transform") for g in group(root, name).iter(f"{SVG}g"))
    found = (re.match(r"translate\((\S+) (\S+)\) rotate\((\S+)\)", shape or "") for shape in shapes)
    return [(float(m[1]), float(m[2]), float(m[3])) for m in found if m]


def test_north_is_up_and_east_is_right() -> None:
    cars = (
        actor("west", "car", -50, 0),
        actor("east", "car", 50, 0, heading=np.pi / 2),
        actor("north", "car", 0, 40, heading=-np.pi / 4),
        actor("south", "car", 0, -40, heading=np.pi),
    )
    west, east, north, south = poses(drawn(replace(bend(), agents=cars)), "agents")
    assert west[0] < north[0] < east[0]
    assert north[1] < east[1] < south[1]
    assert (west[1], north[0]) == pytest.approx((east[1], south[0]))
    assert east[0] - west[0] == pytest.approx(100 / 80 * (south[1] - north[1]), rel=1e-3)
    turns = [pose[2] for pose in (west, east, north, south)]
    assert turns == pytest.approx([0.0, -90.0, 45.0, -180.0], abs=0.01)


@pytest.mark.parametrize(("copies", "label"), [(4, "parked[3]"), (5, "parked (5)")])
def test_up_to_four_copies_have_a_label_each(copies: int, label: str) -> None:
    cars = tuple(actor(f"parked[{i}]", "car", 40.0 * i, 0, group="parked") for i in range(copies))
    labels = texts(group(drawn(replace(bend(), agents=cars)), "labels"))
    assert label in labels
    assert len([text for text in labels if text.startswith("parked")]) == (4 if copies == 4 else 1)


def test_only_what_is_satisfied_has_a_pin_where_it_is_tight() -> None:
    """What is violated is marked where it is violated."""
    scene = bend()
    place = RoadPlace("bent", 100.0)
    phi1 = replace(scene.requirements[0], tightest=place)
    calm = replace(scene.expectations[0], tightest=place)
    root = drawn(replace(scene, requirements=(phi1,), expectations=(calm,)))
    assert texts(group(root, "tightest")) == ["phi1"]
