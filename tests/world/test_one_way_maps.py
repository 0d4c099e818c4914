"""Legends say which roads of a map are one-way, and in which direction."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roadlang.ir.scene import Scene
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]

RAMP = '''
image plan from """
..................
>>>>>>>>>>>>>>>>>>
........^.........
.......^..........
>>>>>>^...........
""" { scale: 20m/px, legend: { ">": eastbound, "^": northbound } }
network town from plan { extract with auto { width: 7m }, lanes: 2 }
'''
MIXED = '''
image plan from """
......#......
......#......
<<<<<<<<<<<<<
......#......
......v......
......v......
......v......
""" { scale: 20m/px, legend: { "#": road, "<": westbound, "v": southbound } }
network town from plan { extract with auto { width: 7m } }
'''


def ways(scene: Scene) -> dict[str, str]:
    """In which direction of the compass the lanes of each road run, by the middle of the road."""
    found = {}
    for road in scene.roads:
        directions = {lane.direction for lane in road.lane_list if lane.drivable}
        x, y = road.x[-1] - road.x[0], road.y[-1] - road.y[0]
        if directions == {"backward"}:
            x, y = -x, -y
        if len(directions) == 1:
            found[road.name] = ("east" if x > 0 else "west") if abs(x) > abs(y) else (
                "north" if y > 0 else "south"
            )  # fmt: skip
        else:
            found[road.name] = "both"
    return found


def test_all_lanes_of_a_one_way_road_run_its_way(sample: Sample) -> None:
    (scene,) = sample(RAMP).scenes
    assert sorted(ways(scene).values()) == ["east", "east", "east"]
    assert all(len(road.lane_list) == 2 for road in scene.roads)


def test_no_turn_leads_against_a_one_way_road(sample: Sample) -> None:
    (scene,) = sample(RAMP).scenes
    (junction,) = scene.networks[0].junctions
    leaves = {turn.target.road for turn in junction.connections}
    enters = {turn.source.road for turn in junction.connections}
    assert len(leaves) == 1
    assert len(enters) == 2
    assert not leaves & enters


def test_roads_that_say_nothing_run_both_ways(sample: Sample) -> None:
    (scene,) = sample(MIXED).scenes
    assert sorted(ways(scene).values()) == ["both", "south", "west", "west"]


def test_colors_of_a_drawing_say_it_too(sample: Sample, tmp_path: Path) -> None:
    cv2, np = pytest.importorskip("cv2"), pytest.importorskip("numpy")
    image = np.full((60, 200, 3), 255, np.uint8)
    cv2.line(image, (10, 30), (190, 30), (0, 0, 200), 7)
    cv2.imwrite(str(tmp_path / "map.png"), image)
    for kind in ("eastbound", "westbound"):
        text = (
            f'image plan from "{tmp_path / "map.png"}" '
            f'{{ scale: 1m/px, legend: {{ "#c80000": {kind} }} }}\n'
            "network town from plan"
        )
        (scene,) = sample(text).scenes
        assert list(ways(scene).values()) == [kind.removesuffix("bound")]


def test_a_route_against_a_one_way_road_is_refused(sample: Sample) -> None:
    with pytest.raises(Exception, match="only in the other direction"):
        sample(RAMP + "agent ego is car on town { route: [(340m, 70m), (20m, 70m)] }")


def test_a_drawn_direction_wins_over_oneway(sample: Sample) -> None:
    (scene,) = sample(RAMP.replace("lanes: 2 }", "lanes: 2, oneway: true }"), 1).scenes
    (drawn,) = sample(RAMP, 1).scenes
    assert ways(scene) == ways(drawn)
