"""`emit commonroad`: lanelets, traffic rules, obstacles and the planning problem."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree.ElementTree import Element, fromstring

import numpy as np
import pytest
from shapely import Polygon

from roadlang import testing
from roadlang.ir.scene import Scene
from roadlang_formats.emit_commonroad import CommonRoadBackend

CROSSING = '''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { %s }
'''
STREET = """
road street { draw with segments { pieces: [straight(200m)] }, lanes: 2, speed_limit: 15m/s }
agent lead is truck on street at 60m { lane: -1, drive with car_follow { speed: 8m/s } }
agent ego is car on street at 20m { lane: -1, drive with car_follow { speed: 10m/s } }
object works is cone on street at 150m { offset: -3m }
object home is building at (100m, 20m)
"""

ZONES = """
road a { draw with segments { pieces: [straight(151m)] }, lanes: 2, speed_limit: 14m/s }
road b { draw with segments { pieces: [straight(103m)] }, lanes: 2, speed_limit: 8m/s }
road all from a { then: [b] }
"""


def scene_of(text: str) -> Scene:
    return testing.sample(text)[0].record


def read(scene: Scene) -> Element:
    return fromstring(CommonRoadBackend().files(scene)["cr.xml"])


def bound(lanelet: Element, tag: str) -> list[tuple[float, float]]:
    points = lanelet.iterfind(f"{tag}/point")
    return [(float(point.findtext("x", "")), float(point.findtext("y", ""))) for point in points]


def refs(element: Element, tag: str) -> list[str]:
    return [child.attrib["ref"] for child in element.iterfind(tag)]


def test_a_street_has_a_lanelet_for_each_lane_in_its_direction() -> None:
    root = read(scene_of(STREET))
    left, right = root.iterfind("lanelet")
    ends = [(0, 0), (200, 0)]
    assert bound(right, "leftBound")[:: len(bound(right, "leftBound")) - 1] == ends
    assert {y for _, y in bound(right, "rightBound")} == {-3.5}
    assert bound(left, "leftBound") == bound(right, "leftBound")[::-1]
    assert [child.attrib for child in right.iterfind("adjacentLeft")] == [
        {"ref": left.attrib["id"], "drivingDir": "opposite"}
    ]
    assert right.find("adjacentRight") is None
    assert right.findtext("leftBound/lineMarking") == "dashed"
    assert root.findtext("trafficSign/trafficSignElement/additionalValue") == "15"


@pytest.mark.parametrize("lanes", [1, 2, 4])
def test_turns_lead_from_lanelet_to_lanelet(lanes: int) -> None:
    scene = scene_of(CROSSING % f"lanes: {lanes}")
    root = read(scene)
    lanelets = {lanelet.attrib["id"]: lanelet for lanelet in root.iterfind("lanelet")}
    turns = [item for item in lanelets.values() if "intersection" in
             [kind.text for kind in item.iterfind("laneletType")]]  # fmt: skip
    assert len(turns) == len(scene.networks[0].junctions[0].connections)
    for turn in turns:
        (before,), (after,) = refs(turn, "predecessor"), refs(turn, "successor")
        for tag in ("leftBound", "rightBound"):
            assert bound(lanelets[before], tag)[-1] == bound(turn, tag)[0]
            assert bound(turn, tag)[-1] == bound(lanelets[after], tag)[0]


def test_an_intersection_knows_its_arms_and_who_comes_from_the_right() -> None:
    root = read(scene_of(CROSSING % "lanes: 2"))
    (intersection,) = root.iterfind("intersection")
    arms = {arm.attrib["id"]: arm for arm in intersection.iterfind("incoming")}
    assert len(arms) == 4
    right_of = {id: refs(arm, "isLeftOf") for id, arm in arms.items()}
    assert sorted(other for (other,) in right_of.values()) == sorted(arms)
    for arm in arms.values():
        for tag in ("successorsLeft", "successorsStraight", "successorsRight"):
            assert len(refs(arm, tag)) == 1


def test_lights_change_as_the_signals_of_the_scene() -> None:
    scene = scene_of(CROSSING % "lanes: 2, control with signals")
    root = read(scene)
    control = scene.networks[0].junctions[0].control
    lights = list(root.iterfind("trafficLight"))
    for light in lights:
        steps = [int(item.findtext("duration", "")) for item in light.iter("cycleElement")]
        assert sum(steps) == pytest.approx(control.cycle / 0.1)
    at = [refs(lanelet, "trafficLightRef") for lanelet in root.iterfind("lanelet")]
    assert sorted(ref for found in at for ref in found) == sorted(x.attrib["id"] for x in lights)
    assert sum(lanelet.find("stopLine") is not None for lanelet in root.iterfind("lanelet")) == 4


def test_minor_roads_have_signs() -> None:
    root = read(scene_of(CROSSING % "lanes: 2, control with stop"))
    kinds = [sign.findtext(".//trafficSignID") for sign in root.iterfind("trafficSign")]
    assert sorted(map(str, kinds)) == ["206", "206", "301", "301"]


def test_what_was_driven_is_dynamic_and_what_stands_is_not() -> None:
    (sample,) = testing.sample(STREET + "simulate with builtin { duration: 5s }")
    trace = sample.run().trace
    before = read(sample.record)
    assert before.find("dynamicObstacle") is None
    assert before.findtext("staticObstacle/type") == "constructionZone"
    assert before.findtext("environmentObstacle/type") == "building"
    after = fromstring(CommonRoadBackend().drive_files(sample.record, trace)["drive.cr.xml"])
    (lead,) = after.iterfind("dynamicObstacle")
    assert lead.findtext("type") == "truck"
    last = list(lead.iterfind("trajectory/state"))[-1]
    assert float(last.findtext("position/point/x", "")) == pytest.approx(
        trace.agents["lead"].x[-1], abs=1e-5
    )
    assert int(last.findtext("time/exact", "")) == len(trace.time) - 1
    assert after.find("planningProblem/goalState/position/rectangle") is not None


def test_the_ego_has_to_reach_the_end_of_its_road() -> None:
    root = read(scene_of(STREET))
    problem = root.find("planningProblem")
    assert problem is not None
    assert problem.findtext("initialState/position/point/x") == "20"
    (goal,) = problem.iterfind("goalState/position/lanelet")
    (_, right) = root.iterfind("lanelet")
    assert goal.attrib["ref"] == right.attrib["id"]


def test_numbers_are_decimals_without_exponents_and_ids_are_unique() -> None:
    bent = "perturb with sine { amplitude: 1m, wavelength: 50m }"
    scene = scene_of(CROSSING % f"lanes: 2, control with signals, {bent}")
    text = CommonRoadBackend().files(scene)["cr.xml"]
    assert text == CommonRoadBackend().files(scene)["cr.xml"]
    assert not re.search(r">-?[\d.]+e[-+]?\d", text)
    ids = [element.attrib["id"] for element in fromstring(text).iter() if "id" in element.attrib]
    assert len(ids) == len(set(ids))


@pytest.mark.parametrize("lanes", ["sidewalk(2m)", "bike(2m)", "parking(2m)"])
def test_a_road_without_vehicles_has_a_planning_problem(lanes: str) -> None:
    road = f"road path {{ draw with segments {{ pieces: [straight(80m)] }}, right: [{lanes}] }}\n"
    root = read(scene_of(road + "agent p is pedestrian on path at 20m { drive with walk }\n"))
    (lanelet,) = root.iterfind("lanelet")
    target = root.find("planningProblem/goalState/position/lanelet")
    assert target is not None
    assert target.attrib == {"ref": lanelet.attrib["id"]}


def test_a_road_without_lanelets_has_no_planning_problem() -> None:
    scene = scene_of(
        "road lawn { draw with segments { pieces: [straight(80m)] }, right: [grass(2m)] }"
    )
    assert read(scene).find("planningProblem") is None


def test_pedestrians_who_stand_are_no_parked_vehicles() -> None:
    root = read(scene_of(STREET + "agent walker is pedestrian on street at 90m { offset: 6m }\n"))
    kinds = [kind.text for kind in root.iterfind("staticObstacle/type")]
    assert "parkedVehicle" not in kinds
    assert "unknown" in kinds


def test_lanelets_end_where_the_speed_limit_changes() -> None:
    root = read(scene_of(ZONES))
    signs = {
        sign.attrib["id"]: float(sign.findtext("trafficSignElement/additionalValue", ""))
        for sign in root.iterfind("trafficSign")
    }
    spans = {
        (round(bound(item, "leftBound")[0][0]), round(bound(item, "leftBound")[-1][0])): [
            signs[ref] for ref in refs(item, "trafficSignRef")
        ]
        for item in root.iterfind("lanelet")
    }
    slow, fast = [8.0], [14.0]
    assert spans == {(0, 151): fast, (151, 254): slow, (254, 151): slow, (151, 0): fast}


def test_the_goal_of_an_ego_that_is_gone_is_where_it_was_last() -> None:
    (sample,) = testing.sample(STREET + "simulate with builtin { duration: 3s }")
    trace = sample.run().trace
    ego = trace.agents["ego"]
    present = (np.arange(len(ego.time)) < 12).astype(float)
    gone = replace(ego, present=present)
    assert gone.samples_there == 12
    left = replace(trace, agents={**trace.agents, "ego": gone})
    after = fromstring(CommonRoadBackend().drive_files(sample.record, left)["drive.cr.xml"])
    center = after.find("planningProblem/goalState/position/rectangle/center")
    assert center is not None
    assert float(center.findtext("x", "")) == pytest.approx(ego.x[11], abs=1e-5)
    assert float(center.findtext("y", "")) == pytest.approx(ego.y[11], abs=1e-5)


def test_who_is_gone_after_the_first_sample_stays_where_it_was() -> None:
    (sample,) = testing.sample(STREET + "simulate with builtin { duration: 1s }")
    trace = sample.run().trace
    lead = trace.agents["lead"]
    gone = replace(lead, present=(np.arange(len(lead.time)) < 1).astype(float))
    left = replace(trace, agents={**trace.agents, "lead": gone})
    after = fromstring(CommonRoadBackend().drive_files(sample.record, left)["drive.cr.xml"])
    (state,) = after.iterfind("dynamicObstacle/trajectory/state")
    assert float(state.findtext("position/point/x", "")) == pytest.approx(lead.x[0], abs=1e-5)
    assert lead.x[1] - lead.x[0] > 0.5


def test_no_lanelet_of_a_road_that_crosses_itself_lies_on_itself() -> None:
    curl = "pieces: [straight(40m), arc(12m, 270deg), straight(40m)]"
    root = read(scene_of(f"road curl {{ draw with segments {{ {curl} }}, lanes: 2 }}"))
    lanelets = list(root.iterfind("lanelet"))
    for lanelet in lanelets:
        outline = Polygon(bound(lanelet, "leftBound") + bound(lanelet, "rightBound")[::-1])
        assert outline.is_valid
    assert len(lanelets) == 4
    assert sum(len(refs(lanelet, "successor")) for lanelet in lanelets) == 2
