"""`read with opendrive`: junctions, links of roads, and who goes first."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry import Curve
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.read_opendrive import OpenDriveMap
from tests.formats.read_maps import CROSSING_TURNS, found_in, lanes_of, sampled, turns_of
from tests.formats.small_maps import (
    TWO_WAY,
    crossing,
    lane,
    link,
    linked,
    piece,
    road,
    section,
    straight,
    xodr,
)


def test_a_junction_has_the_turns_of_the_file_and_no_others(tmp_path: Path) -> None:
    scene = sampled(tmp_path, crossing())
    assert turns_of(scene) == CROSSING_TURNS
    (junction,) = scene.networks[0].junctions
    assert {road.trim for road in scene.roads} == {(0.0, 0.0)}
    assert [arm.road for arm in junction.arms] != []


def test_turns_follow_the_lines_of_the_file(tmp_path: Path) -> None:
    """The right turn is a quarter of a circle of 10 m whose lane lies 1.75 m inside of it."""
    scene = sampled(tmp_path, crossing())
    (junction,) = scene.networks[0].junctions
    right = next(c for c in junction.connections if c.target.road == "town/3")
    assert right.turn == "right"
    ((length, curvature),) = right.pieces
    assert curvature == pytest.approx(-1 / 8.25, rel=1e-4)
    assert length == pytest.approx(8.25 * math.pi / 2, rel=1e-4)


def test_perturbed_roads_keep_meeting_at_their_junctions(tmp_path: Path) -> None:
    scene = sampled(
        tmp_path, crossing(), "{ perturb with sine { amplitude: 3m, wavelength: 30m } }"
    )
    (junction,) = scene.networks[0].junctions
    roads = {road.name: road for road in scene.roads}
    assert turns_of(scene) == CROSSING_TURNS
    assert max(np.abs(road.curvature).max() for road in scene.roads) > 0.01
    for connection in junction.connections:
        source = roads[connection.source.road]
        place = 0 if connection.source.end == "start" else -1
        offset = float(
            source.cross_section().offset(connection.source.lane, source.stations[place])
        )
        x = source.x[place] - offset * math.sin(source.heading[place])
        y = source.y[place] + offset * math.cos(source.heading[place])
        assert math.dist((x, y), connection.start[:2]) < 1e-6


def test_a_map_that_is_written_and_read_again_is_the_same(tmp_path: Path) -> None:
    scene = sampled(tmp_path, crossing())
    again = sampled(tmp_path, OpenDriveBackend().files(scene)["xodr"])
    assert turns_of(again) == CROSSING_TURNS
    for one, other in zip(scene.roads, again.roads, strict=True):
        curve = Curve.hermite(np.column_stack((other.x, other.y)), other.heading)
        assert np.abs(curve.project(np.column_stack((one.x, one.y)))[1]).max() < 0.002


def test_roads_that_follow_one_another_are_joined_lane_by_lane(tmp_path: Path) -> None:
    first = straight(1, 0, 0, inside=link(successor="road 2 start"))
    second = straight(2, 60, 0, inside=link(predecessor="road 1 end"))
    scene = sampled(tmp_path, xodr(first, second))
    (joint,) = scene.networks[0].junctions
    assert joint.kind == "joint"
    assert turns_of(scene) == {("town/1", -1, "town/2", -1), ("town/2", 1, "town/1", 1)}


def test_roads_against_one_another_change_the_signs_of_lanes(tmp_path: Path) -> None:
    first = straight(1, 0, 0, inside=link(successor="road 2 end"))
    back = road(
        2, 60.0, piece(0, 120, 0, math.pi, 60.0), TWO_WAY, inside=link(successor="road 1 end")
    )
    scene = sampled(tmp_path, xodr(first, back))
    assert turns_of(scene) == {("town/1", -1, "town/2", 1), ("town/2", -1, "town/1", 1)}


def test_both_ends_of_a_loop_meet_a_street_in_one_junction(tmp_path: Path) -> None:
    street = straight(1, 0, 0, inside=link(successor="road 2 start"))
    turn = '<arc curvature="0.05"/>'
    loop = road(
        2, 40.0 * math.pi, piece(0, 60, 0, 0.0, 40.0 * math.pi, turn),
        section(0, right=[lane(-1, inside=linked(-1, 1))]),
        inside=link(predecessor="road 1 end", successor="road 1 end"),
    )  # fmt: skip
    scene = sampled(tmp_path, xodr(street, loop))
    (junction,) = scene.networks[0].junctions
    assert len(junction.arms) == 3
    assert turns_of(scene) == {("town/1", -1, "town/2", -1), ("town/2", -1, "town/1", 1)}


def test_agents_drive_through_a_map(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text(crossing())
    text = (
        f'network town from "{tmp_path}/town.xodr"\n'
        "agent ego is car on town at random { drive with pure_pursuit { speed: 8m/s } }\n"
    )
    (ego,) = testing.sample(text)[0].record.agents
    assert ego.road in ("town/1", "town/2", "town/3")


def test_a_road_of_a_map_is_selected_by_its_id(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text(crossing())
    text = f'network town from "{tmp_path}/town.xodr"\nroad main from town {{ select: road(3) }}\n'
    main = next(road for road in testing.sample(text)[0].record.roads if road.name == "main")
    assert (main.x[0], main.y[0]) == pytest.approx((0.0, -50.0))


def test_links_to_roads_that_are_elsewhere_join_nothing(tmp_path: Path) -> None:
    far = straight(1, 0, 0, inside=link(successor="road 2 start")), straight(2, 160, 0)
    path = tmp_path / "town.xodr"
    path.write_text(xodr(*far))
    found = OpenDriveMap().read(path)
    assert found.network.junctions == ()
    assert found.remarks == (
        "road 1 (line 4) leads to road 2, which is 100 m away: they are not joined",
    )


def test_roads_on_the_same_ground_become_one_for_both_directions_again(tmp_path: Path) -> None:
    """`emit opendrive` writes a single lane for both directions as two roads."""
    scene = testing.sample('''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 1 }''')[0].record
    network = found_in(tmp_path, OpenDriveBackend().files(scene)["xodr"]).network
    assert len(network.edges) == sum(road.derived for road in scene.roads) == 4
    assert {lane.direction for edge in network.edges for lane in lanes_of(edge).lanes} == {"both"}
    (junction,) = network.junctions or ()
    assert len(junction.turns) == len(scene.networks[0].junctions[0].connections)
    assert len(junction.arms) == 4


def test_roads_of_left_hand_traffic_that_were_parted_are_whole_again(tmp_path: Path) -> None:
    """`emit opendrive` writes a road for each direction, or roads with `rule="LHT"`."""
    scene = testing.sample('''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 4, sidewalks: 2m, control with stop }
world { traffic: left }''')[0].record
    seen = []
    for written in ("one_way_roads", "rule"):
        text = OpenDriveBackend(left_hand=written).files(scene)["xodr"]
        found = sampled(tmp_path, text, "\nworld { traffic: left }")
        roads = {road.name: place for place, road in enumerate(found.roads)}
        (junction,) = found.networks[0].junctions
        seen.append(
            (
                [(road.x, road.y, road.center_marking, road.lane_list) for road in found.roads],
                {(roads[a], lane, roads[b], to) for a, lane, b, to in turns_of(found)},
                {roads[name] for name in junction.control.minor},
            )
        )
    assert seen[0] == seen[1]
    before, after = scene.roads[0].lane_list, seen[0][0][0][3]
    assert [(lane.id, lane.kind, lane.direction, lane.marking) for lane in after] == [
        (lane.id, lane.kind, lane.direction, lane.marking) for lane in before
    ]
    assert len(seen[0][1]) == len(scene.networks[0].junctions[0].connections)


@pytest.mark.parametrize("rule", ["signals", "stop", "yield", "all_way_stop"])
@pytest.mark.parametrize("lanes", [1, 2])
def test_lights_and_signs_say_who_goes_first(tmp_path: Path, rule: str, lanes: int) -> None:
    """Those that `emit opendrive` writes are read again."""
    scene = testing.sample(f'''image plan from """
...#...
#######
...#...
""" {{ scale: 30m/px }}
network town from plan {{ lanes: {lanes}, control with {rule} }}''')[0].record
    found = sampled(tmp_path, OpenDriveBackend().files(scene)["xodr"])
    (before,), (after,) = scene.networks[0].junctions, found.networks[0].junctions
    assert after.control.kind == rule
    assert len(after.control.phases) == len(before.control.phases)
    assert len(after.control.minor) == len(before.control.minor)
    other = sampled(
        tmp_path, OpenDriveBackend().files(scene)["xodr"], "{ control with right_first }"
    )
    assert other.networks[0].junctions[0].control.kind == "right_first"


def test_a_link_to_a_road_that_does_not_exist_ends_there(tmp_path: Path) -> None:
    """Public maps have such links: parts cut out of larger ones."""
    found = found_in(tmp_path, xodr(straight(1, 0, 0, inside=link(successor="road 8 start"))))
    assert (len(found.network.edges), found.network.junctions) == (1, ())
    assert found.remarks == (
        "road 1 (line 4) leads to road 8, which does not exist: it ends there",
    )


def test_roads_are_linked_across_one_without_length(tmp_path: Path) -> None:
    """Its lane links are followed: lane -1 before it is lane -2 behind it."""
    one = section(0, (), [lane(-1, inside=linked(None, -1))])
    nothing = section(0, (), [lane(-1, inside=linked(-1, -2))])
    wide = section(0, (), [lane(-1), lane(-2, inside=linked(-1))])
    roads = [
        straight(1, 0, 0, lanes=one, inside=link(successor="road 2 start")),
        straight(2, 60, 0, 1e-7, lanes=nothing,
            inside=link(predecessor="road 1 end", successor="road 3 start")),
        straight(3, 60, 0, lanes=wide, inside=link(predecessor="road 2 end")),
    ]  # fmt: skip
    scene = sampled(tmp_path, xodr(*roads))
    assert {road.name for road in scene.roads} == {"town/1", "town/3"}
    assert turns_of(scene) == {("town/1", -1, "town/3", -2)}


def test_roads_are_linked_to_a_junction_across_one_without_length(tmp_path: Path) -> None:
    """Road 9 lies between road 1 and the junction: the turns are those without it."""
    head, _, arm = crossing().partition('<road id="1"')
    arm, found, rest = arm.partition("</road>")
    arm = arm.replace('"junction" elementId="100"', '"road" elementId="9" contactPoint="start"')
    both = section(0, [lane(1, inside=linked(1))], [lane(-1, inside=linked(-1))])
    nothing = road(9, 1e-6, piece(0, -10, 0, 0.0, 1e-6), both,
        inside=link(predecessor="road 1 end", successor="junction 100"))  # fmt: skip
    rest = rest.replace('elementId="1"', 'elementId="9"').replace('Road="1"', 'Road="9"')
    scene = sampled(tmp_path, f'{head}<road id="1"{arm}{found}{nothing}{rest}')
    assert {road.name for road in scene.roads} == {"town/1", "town/2", "town/3"}
    assert turns_of(scene) == CROSSING_TURNS
