"""Agents, objects, their labels, and what is painted at junctions, by hand: ten pixels a meter."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.ir.scene_junctions import (
    SceneArm,
    SceneConnection,
    SceneControl,
    SceneJunction,
    SceneLaneEnd,
    SignalPhase,
)
from roadlang.scenes.turn_arrows import arrow
from roadlang_standard.svg import actors, palette, shapes, trees
from roadlang_standard.svg.junctions import curbs, heads, paint
from roadlang_standard.svg.labels import PixelBox, actor_labels
from tests.backends.handmade_scenes import actor, bend
from tests.backends.svg_shapes import PAGE, Shape, ends, numbers, of, points, straight, written

FONT = 10.0


def near(*values: float) -> object:
    return pytest.approx(values, abs=0.02)


def scene(*agents: Any, objects: tuple[Any, ...] = ()) -> Scene:
    return replace(bend(), agents=agents, objects=objects, roads=())


def spread(shape: Shape) -> tuple[float, float, float, float]:
    """Least and greatest x and y of a polygon."""
    xs, ys = zip(*points(shape), strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def test_a_thing_is_drawn_at_its_place_in_its_size_and_turned() -> None:
    car = actor("ego", "car", 30, 10, heading=math.radians(30), length=4.0, width=2.0,
                road="main", start=12.34)  # fmt: skip
    drawn = actors.agents(scene(car), PAGE)
    moved = [shape.get("transform") for shape in of(drawn, "g")]
    assert moved == [None, "translate(300.00 400.00) rotate(-30.00)"]
    body = of(drawn, "rect")[0]
    assert numbers(body, "x", "y", "width", "height") == [-20, -10, 40, 20]
    assert [hint.text for hint in of(drawn, "title")] == ["ego: car at 12.3 m on main"]
    assert of(actors.agents(scene(replace(car, start=None)), PAGE), "title")[0].text == "ego: car"


@pytest.mark.parametrize(
    ("length", "width", "drawn"),
    [(4.0, 2.0, (40, 20)), (1.5, 1.0, (15, 10)), (0.75, 0.5, (15, 10)), (0.5, 1.0, (7.5, 15))],
)
def test_a_small_agent_is_enlarged_to_15_pixels(
    length: float, width: float, drawn: tuple[float, float]
) -> None:
    """Its longer side decides, and it keeps its shape."""
    car = actor("ego", "car", 0, 0, length=length, width=width)
    body = of(actors.agents(scene(car), PAGE), "rect")[0]
    assert numbers(body, "width", "height") == near(*drawn)


def test_a_small_object_is_enlarged_to_3_pixels() -> None:
    cone = actor("cone", "acme.cone", 0, 0, length=0.2, width=0.1)
    body = of(actors.objects(scene(objects=(cone,)), PAGE), "rect")[0]
    assert numbers(body, "width", "height") == near(3, 1.5)


def test_crowns_of_trees_lie_over_other_objects() -> None:
    things = (actor("tree", "tree", 0, 0), actor("bush", "acme.bush", 0, 0),
              actor("kiosk", "building", 0, 0))  # fmt: skip
    hints = [hint.text for hint in of(actors.objects(scene(objects=things), PAGE), "title")]
    assert hints == ["kiosk: building", "tree: tree", "bush: bush"]


@pytest.mark.parametrize(
    ("kind", "tags"),
    [
        ("parked_van", ["rect", "polygon", "polygon", "path"]),
        ("acme.truck", ["rect", "rect", "polygon"]),
        ("motorcycle", ["line", "line", "ellipse"]),
        ("pedestrian", ["ellipse", "circle"]),
        ("bush", ["path", "path", "path"]),
        ("building", ["rect", "polygon", "polygon", "polygon"]),
        ("crate", ["rect", "polygon"]),
    ],
)
def test_each_kind_has_a_drawing(kind: str, tags: list[str]) -> None:
    drawn = actors.agents(scene(actor("it", kind, 0, 0)), PAGE)
    found = [shape.tag for shape in of(drawn, "g")[1]]
    assert found == ["title", *tags]


@pytest.mark.parametrize(
    ("color", "fill"),
    [("#1f5fa8", "#1f5fa8"), ("red", "red"), ("#12", palette.OBJECT), ("Red;", palette.OBJECT),
     (7, palette.OBJECT), (None, palette.OBJECT)],
)  # fmt: skip
def test_a_body_has_the_color_of_its_options(color: object, fill: str) -> None:
    options = {} if color is None else {"color": color}
    car = actor("ego", "car", 0, 0, options=options)
    assert of(actors.agents(scene(car), PAGE), "rect")[0].get("fill") == fill


def test_a_car_looks_ahead() -> None:
    """40 x 20 pixels, ahead is x: the windscreen before the rear window, both inside the body."""
    drawn = shapes.car(40.0, 20.0, "red")
    (body,), (screen, rear), (lights,) = (of(drawn, tag) for tag in ("rect", "polygon", "path"))
    assert numbers(body, "x", "y", "width", "height", "rx", "stroke-width") == near(
        -20, -10, 40, 20, 5.6, 1
    )
    assert spread(screen) == near(3.2, 8.8, -8, 8)
    assert spread(rear) == near(-13.6, -8.8, -7.6, 7.6)
    assert [y for _, y in points(lights)] == near(8.4, -8.4)
    assert [x for x, _ in points(lights)] == near(18, 18)


def test_a_truck_has_its_cab_in_front() -> None:
    box, cab = of(shapes.truck(100.0, 25.0, "red"), "rect")
    assert numbers(box, "x", "y", "width", "height") == near(-50, -12.5, 74, 25)
    assert numbers(cab, "x", "y", "width", "height") == near(26, -11.5, 24, 23)
    (glass,) = of(shapes.truck(100.0, 25.0, "red"), "polygon")
    assert spread(glass) == near(36.8, 42.32, -10, 10)


def test_two_wheels_are_in_line_and_the_handlebar_is_before_the_rider() -> None:
    frame, bar = of(shapes.bicycle(20.0, 10.0, "red"), "line")
    assert numbers(frame, "x1", "y1", "x2", "y2") == [-10, 0, 10, 0]
    assert numbers(bar, "x1", "y1", "x2", "y2") == [5, -5, 5, 5]
    assert numbers(bar, "stroke-width") == near(1.2)
    (rider,) = of(shapes.bicycle(20.0, 10.0, "red"), "ellipse")
    assert numbers(rider, "rx", "ry") == near(3.2, 3.8)


def test_a_pedestrian_is_wider_than_deep() -> None:
    (shoulders,) = of(shapes.pedestrian(6.0, 10.0, "red"), "ellipse")
    (head,) = of(shapes.pedestrian(6.0, 10.0, "red"), "circle")
    assert numbers(shoulders, "rx", "ry") == near(3, 5.2)
    assert numbers(head, "cx", "r") == near(0.4, 2.4)


def test_the_layers_of_a_crown_are_smaller_one_by_one() -> None:
    first, other = trees.crowns([50.0, 50.0], [0, 1])
    crowns = of(first, "path")
    assert [crown.get("fill") for crown in crowns] == list(reversed(palette.LEAVES))
    assert [(crown.get("d") or "").count("A") for crown in crowns] == [9, 7, 5]
    # The first corner lies at 0.86 of the radius of 25, 17.5 and 9.5 px around centers that
    # wander by 3 px a layer.
    for layer, (crown, radius) in enumerate(zip(crowns, (25.0, 17.5, 9.5), strict=True)):
        start = (crown.get("d") or "")[1:].split("A")[0].split()
        assert math.hypot(float(start[0]), float(start[1])) == pytest.approx(
            0.86 * radius + 3.0 * layer, abs=0.02
        )
    assert first != other


def test_trees_too_small_for_lobes_are_discs_of_their_size() -> None:
    large, small = trees.crowns([6.0, 5.0], [0, 1])
    assert len(of(large, "path")) == 3
    outer, inner = of(small, "circle")
    assert (outer.get("r"), inner.get("r")) == ("2.5", "0.95")
    assert [outer.get("fill"), inner.get("fill")] == [palette.LEAVES[2], palette.LEAVES[0]]


def test_a_roof_has_its_ridge_along_the_longer_side() -> None:
    dark, back, front = of(shapes.building(120.0, 80.0), "polygon")
    assert points(dark) == [(-60, 40), (60, 40), (24, 0), (-24, 0)]
    assert points(back) == [(-60, -40), (-60, 40), (-24, 0)]
    assert points(front) == [(60, -40), (60, 40), (24, 0)]
    (base,) = of(shapes.building(120.0, 80.0), "rect")
    assert numbers(base, "x", "y", "width", "height") == [-60, -40, 120, 80]
    assert base.get("rx") is None


def test_a_block_has_a_mark_at_its_front() -> None:
    (mark,) = of(shapes.block(40.0, 20.0, "red"), "polygon")
    assert points(mark) == [(20, 0), (15, -5), (15, 5)]


@pytest.mark.parametrize(("width", "line"), [(4.0, 0.4), (20.0, 1.0), (100.0, 1.4)])
def test_outlines_are_neither_too_thin_nor_too_thick(width: float, line: float) -> None:
    (body,) = of(shapes.block(40.0, width, "red"), "rect")
    assert numbers(body, "stroke-width") == near(line)


def test_labels_stand_above_and_give_way_to_each_other() -> None:
    """A car of 40 px: its label is half of that and 6 px above; the next find their places below,
    to the left, to the right, and higher up."""
    cars = [actor(n, "car", 50, 25, length=4.0) for n in ("one", "two", "six", "ten", "all")]
    labels = written(actor_labels(scene(*cars), PAGE, FONT))
    assert [name for name, _, _ in labels] == [car.name for car in cars]
    # Beside the car stand 20 px of it, 2 px, and half of a label of 25.6 px.
    assert [x for _, x, _ in labels] == near(500, 500, 465.2, 534.8, 500)
    assert [y for _, _, y in labels] == near(224, 283, 253.5, 253.5, 212.5)


def test_labels_need_not_give_way_to_those_beside_them() -> None:
    """Three letters take 21.6 px, and 2 px on either side."""
    for apart, y in ((2.6, 224), (2.5, 283)):
        cars = [actor(n, "car", x, 25, length=4.0) for n, x in (("one", 50), ("two", 50 + apart))]
        assert written(actor_labels(scene(*cars), PAGE, FONT))[1][2] == pytest.approx(y)


def test_labels_give_way_to_what_else_is_written() -> None:
    """A mark of arc length stands where the label of the first car would be: it moves below. Where
    everything is taken, it stands above."""
    car = actor("one", "car", 50, 25, length=4.0)
    for taken, y in ((PixelBox.around(515, 226, 10, 8), 283), (PixelBox(0, 0, 1000, 1000), 224)):
        ((_, _, base),) = written(actor_labels(scene(car), PAGE, FONT, [taken]))
        assert base == pytest.approx(y)


def test_labels_do_not_cover_what_they_do_not_name() -> None:
    """The label of the second car would be on the first, 30 px above: it moves below."""
    cars = [actor(n, "car", 50, y, length=4.0) for n, y in (("one", 28), ("two", 25))]
    labels = written(actor_labels(scene(*cars), PAGE, FONT))
    assert [y for _, _, y in labels] == near(194, 283)


def test_a_small_thing_has_its_label_clear_of_its_drawing() -> None:
    ant = actor("ant", "car", 50, 25, length=0.2, width=0.1)
    ((_, _, y),) = written(actor_labels(scene(ant), PAGE, FONT))
    assert y == 250 - 7.5 - 6


@pytest.mark.parametrize(("count", "labeled"), [(12, True), (13, False)])
def test_objects_are_labeled_unless_there_are_many(count: int, labeled: bool) -> None:
    poles = tuple(actor(f"pole{i}", "pole", 5.0 * i, 0) for i in range(count))
    house = actor("house", "acme.building", 0, 0)
    names = [
        name for name, _, _ in written(actor_labels(scene(objects=(*poles, house)), PAGE, FONT))
    ]
    assert names == ([pole.name for pole in poles] if labeled else [])


# Junctions: the road `main` ends at x = 80 m, where a stop line of 4 m crosses its right half.


def connection(
    number: int, turn: Any = "straight", lane: int = -1, end: Any = "end"
) -> SceneConnection:
    source = SceneLaneEnd("main", end, lane)
    return SceneConnection(
        id=number, source=source, target=SceneLaneEnd("other", "start", -1), turn="straight",
        start=(80.0, 23.0, 0.0), pieces=((10.0, 0.0),), length=10.0, widths=(4.0, 4.0),
        stop_line=((80.0, 25.0), (80.0, 21.0)),
    )  # fmt: skip


def junction(*connections: SceneConnection, **changes: Any) -> SceneJunction:
    area = ((80.0, 21.0), (100.0, 21.0), (100.0, 29.0), (80.0, 29.0))
    plain = SceneJunction(1, (1,), "junction", area, (SceneArm("main", "end", 20.0, 3, 0),),
                          connections)  # fmt: skip
    return replace(plain, **changes)


def painted(place: SceneJunction, road: SceneRoad | None = None) -> list[Shape]:
    """What is painted on the road at a junction, without the edge lines around its corners."""
    trimmed = replace(bend(), roads=(road or straight(trim=(0.0, 20.0)),))
    return of(paint(trimmed, [replace(place, arms=())], PAGE), "path")


STOP = SceneControl("stop", minor=("main",))


def test_a_stop_line_is_40_cm_wide_where_the_lane_ends() -> None:
    (line,) = painted(junction(connection(1), control=STOP))
    assert (*ends(line), *numbers(line, "stroke-width")) == near(800, 250, 800, 290, 4)
    assert line.get("stroke-dasharray") is None


def test_a_line_to_yield_at_is_broken_into_half_meters() -> None:
    (line,) = painted(junction(connection(1), control=SceneControl("yield", minor=("main",))))
    assert line.get("stroke-dasharray") == "5.00 4.00"


@pytest.mark.parametrize(
    ("control", "count"),
    [(SceneControl("stop", minor=("other",)), 0), (SceneControl("yield", minor=("other",)), 0),
     (SceneControl("all_way_stop"), 1), (SceneControl("signals"), 1), (SceneControl(), 0)],
)  # fmt: skip
def test_lines_are_painted_for_whom_they_concern(control: SceneControl, count: int) -> None:
    assert len(painted(junction(connection(1), control=control))) == count


def test_who_enters_a_roundabout_yields_but_not_who_is_on_it() -> None:
    ring = junction(connection(1), kind="roundabout", yields=((1, 2),))
    (line,) = painted(ring)
    assert line.get("stroke-dasharray") is not None
    assert painted(replace(ring, yields=((2, 1),))) == []
    assert painted(replace(ring, kind="junction")) == []


def test_nothing_is_painted_where_one_road_goes_on_in_another() -> None:
    assert painted(junction(connection(1), kind="joint", control=STOP)) == []


def test_an_arrow_lies_9_meters_before_the_stop_line_in_the_middle_of_its_lane() -> None:
    """Its lane lies from y = 21 m to 25 m: the arrow points along y = 23 m to the east."""
    place = junction(connection(1), connection(2, lane=-2))
    shaft, head, *others = painted(place)
    assert ends(shaft) == near(800 - 90 - 16, 270, 800 - 90 + 10, 270)
    assert points(head) == [(720, 266.5), (729, 270), (720, 273.5)]
    assert numbers(shaft, "stroke-width") == near(1.5)
    assert len(others) == 2
    assert painted(junction(connection(1))) == []


def test_an_arrow_at_the_start_of_a_road_points_to_the_start() -> None:
    line = ((20.0, 25.0), (20.0, 29.0))
    both = [replace(connection(i, lane=i, end="start"), stop_line=line) for i in (1, 2)]
    shaft = painted(junction(*both), straight(trim=(20.0, 0.0)))[0]
    assert ends(shaft) == near(290 + 16, 230, 290 - 10, 230)


@pytest.mark.parametrize(("trim", "count"), [(85.9, 4), (86.1, 0)])
def test_a_road_shorter_than_14_meters_has_no_room_for_arrows(trim: float, count: int) -> None:
    place = junction(connection(1), connection(2, lane=-2))
    assert len(painted(place, straight(trim=(0.0, trim)))) == count


def test_the_edge_line_goes_around_the_corners_of_a_junction() -> None:
    place = junction(connection(1))
    trimmed = replace(bend(), roads=(straight(trim=(0.0, 20.0)),))
    (line,) = of(paint(trimmed, [place], PAGE), "path")
    assert ends(line) == near(802.5, 210, 802.5, 290)
    assert line.get("stroke-dasharray") is None


def turned(turn: str) -> tuple[list[float], list[float]]:
    """Where the head of an arrow begins, and its direction: east is (1, 0), north (0, 1)."""
    (_, _), (head, filled) = arrow([turn], 0.0, 0.0, 0.0)
    assert filled
    foot, tip = (head[0] + head[2]) / 2, head[1]
    return foot.tolist(), ((tip - foot) / 0.9).tolist()


@pytest.mark.parametrize(
    ("turn", "foot", "degrees"),
    [("straight", (1.0, 0.0), 0), ("left", (0.0, 0.5), 50), ("right", (0.0, -0.5), -50),
     ("u", (-0.4, 0.7), 150)],
)  # fmt: skip
def test_an_arrow_turns_to_where_its_lane_leads(
    turn: str, foot: tuple[float, float], degrees: float
) -> None:
    angle = math.radians(degrees)
    begins, direction = turned(turn)
    assert begins == near(*foot)
    assert direction == near(math.cos(angle), math.sin(angle))


def test_an_arrow_lies_along_its_lane() -> None:
    (line, _), _ = arrow(["straight"], 10.0, 5.0, math.pi / 2)
    assert line.ravel() == near(10, 3.4, 10, 6)
    assert len(arrow(["left", "straight"], 0, 0, 0)) == 4


PHASES = (SignalPhase((1,), 10.0, 3.0, 2.0), SignalPhase((2,), 5.0, 3.0, 2.0))


@pytest.mark.parametrize(
    ("time", "first", "second"),
    [
        (0.0, "green", "red"), (9.9, "green", "red"), (10.0, "yellow", "red"),
        (12.9, "yellow", "red"), (13.0, "red", "red"), (14.9, "red", "red"),
        (15.0, "red", "green"), (19.9, "red", "green"), (20.0, "red", "yellow"),
        (23.0, "red", "red"), (24.9, "red", "red"), (25.0, "green", "red"),
    ],
)  # fmt: skip
def test_lights_follow_their_phases(time: float, first: str, second: str) -> None:
    control = SceneControl("signals", (), PHASES)
    assert (control.light(1, time), control.light(2, time)) == (first, second)
    assert replace(control, offset=4.0).light(1, time) == control.light(1, time + 4.0)


def test_a_signal_stands_80_cm_to_the_right_of_its_stop_line() -> None:
    place = junction(connection(1), control=SceneControl("signals", (), PHASES))
    (head,) = of(heads([place], PAGE), "circle")
    assert numbers(head, "cx", "cy", "r", "stroke-width") == near(800, 298, 5.5, 1.925)
    assert head.get("fill") == palette.LIGHTS["green"]
    assert not of(heads([replace(place, control=SceneControl("signals"))], PAGE), "circle")


def test_a_curb_runs_inside_the_area_but_not_where_a_road_begins() -> None:
    """The road takes the western side; the line of 2 px turns 1 px away from each corner."""
    (line,) = of(curbs(junction(), PAGE, 2.0), "path")
    assert [value for pair in points(line) for value in pair] == pytest.approx(
        [800.7, 289.3, 999.3, 289.3, 999.3, 210.7, 800.7, 210.7], abs=0.02
    )
