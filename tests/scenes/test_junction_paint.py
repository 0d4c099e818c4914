"""What is painted at junctions, and where signals stand."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np
import pytest

from roadlang.ir.scene import Scene
from roadlang.ir.scene_junctions import SceneControl, SceneJunction, SignalPhase
from roadlang.scenes.junction_paint import PaintedShape, junction_paint
from roadlang.scenes.paint_rings import paint_rings
from roadlang.scenes.sampling import SamplingResult
from roadlang.scenes.signal_heads import signal_heads

Sample = Callable[..., SamplingResult]
CROSSING = '''
image plan from """
....#....
....#....
#########
....#....
....#....
""" { scale: 30m/px, legend: { "#": road } }
WORLD
network town from plan { LANES }
'''
SIDEWALKS = "left: [drive(3.5m), sidewalk(2m)]\nright: [drive(3.5m), sidewalk(2m)]\n"


def crossing(sample: Sample, lanes: str, world: str = "") -> tuple[Scene, SceneJunction]:
    source = CROSSING.replace("LANES", lanes).replace("WORLD", world)
    scene = sample(source).scenes[0]
    (junction,) = scene.networks[0].junctions
    return scene, junction


def painted(scene: Scene, junction: SceneJunction, kind: str) -> list[PaintedShape]:
    return [shape for shape in junction_paint(scene, [junction]) if shape.kind == kind]


def test_people_cross_between_sidewalks(sample: Sample) -> None:
    """Stripes of half a meter with gaps of half a meter, across both lanes of each of the roads."""
    scene, junction = crossing(sample, SIDEWALKS)
    stripes = painted(scene, junction, "crossing")
    driven = sum(lane.width[0] for lane in scene.roads[0].lane_list if lane.drivable)
    assert len(stripes) == 4 * int((driven + 0.5) // 1.0)
    for stripe in stripes:
        sides = np.hypot(*(np.roll(stripe.points, -1, axis=0) - stripe.points).T)
        assert sides == pytest.approx([0.5, 3.0, 0.5, 3.0])


def test_stripes_lie_inside_the_area_beyond_the_stop_line(sample: Sample) -> None:
    scene, junction = crossing(sample, SIDEWALKS + "control with all_way_stop")
    lines = [shape.points.mean(axis=0) for shape in painted(scene, junction, "stop_line")]
    middle = np.mean(junction.area, axis=0)
    for stripe in painted(scene, junction, "crossing"):
        farthest = max(np.hypot(*(point - middle)) for point in lines)
        assert np.hypot(*(stripe.points - middle).T).max() < 1.5 * farthest
        near = min(np.hypot(*(stripe.points - line).T).min() for line in lines)
        assert near > 0.5


def test_arrows_are_painted_in_their_lanes_before_the_stop_lines(sample: Sample) -> None:
    scene, junction = crossing(sample, "lanes: 4, control with all_way_stop")
    ends = {connection.source.end for connection in junction.connections}
    lines = np.array([shape.points.mean(axis=0) for shape in painted(scene, junction, "stop_line")])
    arrows = [shape.points.mean(axis=0) for shape in painted(scene, junction, "arrow")]
    middle = np.mean(junction.area, axis=0)
    assert ends == {"start", "end"}
    assert len(arrows) >= len(lines) == 8
    for arrow in arrows:
        line = lines[np.hypot(*(lines - arrow).T).argmin()]
        away = (line - middle) / np.hypot(*(line - middle))
        assert 2.0 < (arrow - line) @ away < 12.0
        assert np.hypot(*(arrow - line)) < 14.0


def test_without_sidewalks_nobody_crosses(sample: Sample) -> None:
    scene, junction = crossing(sample, "lanes: 2")
    assert not painted(scene, junction, "crossing")


def test_signals_stand_beside_the_lane_that_they_are_for(sample: Sample) -> None:
    _, junction = crossing(sample, "lanes: 2\ncontrol with signals")
    heads = list(signal_heads(junction))
    assert len(heads) == 4
    starts = {c.id: c for c in junction.connections}
    for head in heads:
        connection = starts[head.connections[0]]
        right = np.array(connection.stop_line[1])
        across = np.array([math.sin(head.heading), -math.cos(head.heading)])
        assert np.array([head.x, head.y]) == pytest.approx(right + 0.8 * across)


def test_in_left_hand_traffic_signals_stand_on_the_left(sample: Sample) -> None:
    _, junction = crossing(
        sample, "lanes: 2\ncontrol with signals", world="world { traffic: left }"
    )
    starts = {c.id: c for c in junction.connections}
    heads = list(signal_heads(junction))
    assert len(heads) == 4
    for head in heads:
        left = np.array(starts[head.connections[0]].stop_line[0])
        across = np.array([-math.sin(head.heading), math.cos(head.heading)])
        assert np.array([head.x, head.y]) == pytest.approx(left + 0.8 * across)


@pytest.mark.parametrize(
    ("time", "first", "second"),
    [
        (0.0, "green", "red"),
        (7.9, "green", "red"),
        (8.0, "yellow", "red"),
        (11.0, "red", "red"),
        (12.5, "red", "green"),
        (21.9, "red", "green"),
        (22.0, "red", "yellow"),
        (25.0, "red", "red"),
        (27.0, "green", "red"),
        (37.1, "yellow", "red"),
    ],
)
def test_phases_follow_one_another(time: float, first: str, second: str) -> None:
    """10 s green, 3 s yellow, 1.5 s red for all, in turn; two seconds have passed at the start."""
    phases = (SignalPhase((0,), 10.0, 3.0, 1.5), SignalPhase((1,), 9.5, 3.0, 2.0))
    control = SceneControl("signals", (), phases, offset=2.0)
    assert control.cycle == 29.0
    assert (control.light(0, time), control.light(1, time)) == (first, second)


@pytest.mark.parametrize("traffic", ["right", "left"])
def test_the_priority_road_keeps_its_lines_through_the_mouth_of_a_t(
    sample: Sample, traffic: str
) -> None:
    """Without them until now: its middle line, broken, and its edge line along the mouth only."""
    source = CROSSING.split('....#....\n....#....\n"""')[0] + '"""' + CROSSING.split('"""')[2]
    world = f"world {{ traffic: {traffic} }}"
    source = source.replace("WORLD", world).replace(
        "LANES", "extract with auto { width: 8m }\nlanes: 2\ncontrol with yield"
    )
    scene = sample(source).scenes[0]
    (junction,) = scene.networks[0].junctions
    (minor,) = junction.control.minor
    faces = {
        a.road: np.array([junction.area[a.left], junction.area[a.right]]) for a in junction.arms
    }
    mouth = faces.pop(minor).mean(axis=0)
    west, east = sorted(face.mean(axis=0)[0] for face in faces.values())
    (middle,) = {round(face.mean(axis=0)[1], 6) for face in faces.values()}
    lane, edge = (painted(scene, junction, kind) for kind in ("lane_line", "edge_line"))
    xs = np.array([dash.points[:, 0] for dash in sorted(lane, key=lambda one: one.points[0, 0])])
    assert np.array([dash.points[:, 1] for dash in lane]) == pytest.approx(middle, abs=1e-6)
    assert (xs.min(), xs.max()) == pytest.approx((west, east))
    dashes, gaps = np.ptp(xs, axis=1), xs[1:].min(axis=1) - xs[:-1].max(axis=1)
    assert dashes == pytest.approx(dashes[0])
    assert gaps == pytest.approx(dashes[0])
    assert 2.0 < dashes[0] < 4.5
    side = np.sign(mouth[1] - middle)
    assert len(edge) >= 3
    for dash in edge:
        assert dash.points[:, 1] == pytest.approx(middle + side * (4.0 - 0.25), abs=1e-6)
        assert west < dash.points[:, 0].min() < dash.points[:, 0].max() < east


def test_the_line_beside_a_bike_lane_goes_on_where_it_was(sample: Sample) -> None:
    """On the border itself: only at the edge of a road is a line painted inside it."""
    lanes = "left: [drive(3.5m), bike(1.5m)]\nright: [drive(3.5m), bike(1.5m)]\n"
    scene, junction = crossing(sample, lanes + "control with yield")
    edges = painted(scene, junction, "edge_line")
    major = [arm for arm in junction.arms if arm.road not in junction.control.minor]
    face = np.array([junction.area[major[0].left], junction.area[major[0].right]])
    axis = int(np.ptp(face[:, 1]) > np.ptp(face[:, 0]))
    away = np.abs(
        np.concatenate([dash.points for dash in edges])[:, axis] - face.mean(axis=0)[axis]
    )
    assert away == pytest.approx(3.5, abs=1e-6)


@pytest.mark.parametrize(
    ("control", "lane", "edge"),
    [
        ("stop", 3, 2),
        ("yield", 3, 2),
        ("all_way_stop", 0, 0),
        ("signals", 0, 0),
        ("right_first", 0, 0),
    ],
)
def test_lines_go_on_only_where_one_road_has_priority(
    sample: Sample, control: str, lane: int, edge: int
) -> None:
    """Of four lanes: the middle line and two lane lines; an edge line at each of two mouths."""
    scene, junction = crossing(sample, f"lanes: 4\ncontrol with {control}")
    for kind, count in (("lane_line", lane), ("edge_line", edge)):
        dashes = painted(scene, junction, kind)
        middles = np.array([dash.points.mean(axis=0) for dash in dashes]).reshape(-1, 2)
        assert min(len(np.unique(column.round(2))) for column in middles.T) == count


def test_the_side_opposite_the_mouth_of_a_t_has_its_edge_line(sample: Sample) -> None:
    """A road from west to east, and one from the north: a solid line along the south."""
    plan = CROSSING.replace("#########\n....#....\n....#....", "#########\n.........\n.........")
    scene = sample(plan.replace("LANES", "lanes: 2").replace("WORLD", "")).scenes[0]
    (junction,) = scene.networks[0].junctions
    lines = painted(scene, junction, "corner_line")
    assert len(lines) == 3
    middle = np.array(junction.area).mean(axis=0)
    (south,) = (line.points for line in lines if (line.points[:, 1] < middle[1] - 2.0).all())
    border = np.array(junction.area)[:, 1].min()
    np.testing.assert_allclose(south[:, 1], border + 0.25, atol=0.02)
    rings = list(paint_rings([lines[0]]))
    for first, last in itertools.pairwise(rings):
        np.testing.assert_allclose(first[[1, 2]], last[[0, 3]])  # no gaps between them
