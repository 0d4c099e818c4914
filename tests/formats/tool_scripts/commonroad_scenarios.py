"""CommonRoad files, by its own reader, schema and collision checker. Runs with their Python.

Question: a list of files. Answer: by file, what is wrong with it.
"""

from __future__ import annotations

import json
import sys
import warnings
from pathlib import Path
from typing import Any

import commonroad
from commonroad.common.file_reader import CommonRoadFileReader
from commonroad.scenario.lanelet import LaneletType
from commonroad.scenario.obstacle import ObstacleType
from commonroad_dc.boundary.boundary import create_road_boundary_obstacle
from commonroad_dc.collision.collision_detection.pycrcc_collision_dispatch import (
    create_collision_checker,
    create_collision_object,
)
from commonroad_dc.pycrcc import CollisionChecker
from lxml import etree
from shapely.ops import unary_union

_LONG = 6.0
"""Meters: longer vehicles cut the inside of tight bends, wherever they are."""
_NEAR, _SAME = 5.0, 1e-3
"""Meters within which lanelets matter, and within which they meet."""
_SCHEMA = Path(commonroad.__file__).parent / (
    "scenario_definition/xml_definition_files/XML_commonRoad_XSD.xsd"
)


def faults(file: str, schema: Any) -> list[str]:
    """Of one file."""
    if not schema.validate(etree.parse(file)):
        return [f"schema: {schema.error_log.last_error}"]
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        scenario, problems = CommonRoadFileReader(file).open()
    found = [f"warning: {item.message}" for item in warned if "eprecat" not in str(item.message)]
    network = scenario.lanelet_network
    found += _unlinked(network)
    _, boundary = create_road_boundary_obstacle(scenario)
    off_road = CollisionChecker()
    off_road.add_collision_object(boundary)
    create_collision_checker(scenario)
    for obstacle in scenario.dynamic_obstacles:
        if obstacle.obstacle_type is ObstacleType.PEDESTRIAN:
            continue
        places = [state.position for state in obstacle.prediction.trajectory.state_list]
        is_long = obstacle.obstacle_shape.length > _LONG
        ends = [places[0], places[-1]]
        begins = create_collision_object(obstacle.occupancy_at_time(0).shape)
        is_on_lanes = all(network.find_lanelet_by_position(ends if is_long else places))
        if not is_on_lanes or (not is_long and off_road.collide(begins)):
            found.append(f"dynamic obstacle {obstacle.obstacle_id} leaves the road")
        elif not is_long and _sticks_out(obstacle, network, off_road):
            found.append(f"a part of dynamic obstacle {obstacle.obstacle_id} leaves the road")
    for problem in problems.planning_problem_dict.values():
        place = problem.initial_state.position
        if not network.find_lanelet_by_position([place])[0]:
            found.append("the planning problem does not begin on the road")
        if problem.goal.lanelets_of_goal_position is None and not problem.goal.state_list:
            found.append("the planning problem has no goal")
    return found


def _sticks_out(obstacle: Any, network: Any, off_road: Any) -> bool:
    """Whether any of its footprint is beside the road at any time; in junctions, whose area is not
    all of lanelets, it may be: where its middle is in one, or what is out is nearest to one."""
    for state in obstacle.prediction.trajectory.state_list:
        shape = obstacle.occupancy_at_time(state.time_step).shape
        if off_road.collide(create_collision_object(shape)):
            ids = network.find_lanelet_by_position([state.position])[0]
            types = [kind for id in ids for kind in network.find_lanelet_by_id(id).lanelet_type]
            if LaneletType.INTERSECTION not in types and _is_out(shape.shapely_object, network):
                return True
    return False


def _is_out(body: Any, network: Any) -> bool:
    """Whether some part of it that is on no lanelet is nearest to one outside of junctions."""
    near = [
        (lanelet.polygon.shapely_object, LaneletType.INTERSECTION in lanelet.lanelet_type)
        for lanelet in network.lanelets
        if lanelet.polygon.shapely_object.distance(body) < _NEAR
    ]
    out = body.difference(unary_union([area.buffer(_SAME) for area, _ in near]))
    for part in getattr(out, "geoms", [out]):
        if not part.is_empty:
            place = part.representative_point()
            least = min(area.distance(place) for area, _ in near)
            if not any(inside for area, inside in near if area.distance(place) < least + _SAME):
                return True
    return False


def _unlinked(network: Any) -> list[str]:
    """Links that hold one way only, or between lanelets that do not meet."""
    found = []
    for lanelet in network.lanelets:
        for id in lanelet.successor:
            after = network.find_lanelet_by_id(id)
            if lanelet.lanelet_id not in after.predecessor:
                found.append(f"lanelet {id} does not know {lanelet.lanelet_id} before it")
            gaps = [
                abs(one[-1] - other[0]).max()
                for one, other in (
                    (lanelet.left_vertices, after.left_vertices),
                    (lanelet.right_vertices, after.right_vertices),
                )
            ]
            if max(gaps) > 1e-6:
                found.append(f"lanelets {lanelet.lanelet_id} and {id} do not meet")
    return found


def main() -> None:
    """Answer the question on standard input."""
    schema = etree.XMLSchema(etree.parse(str(_SCHEMA)))
    print(json.dumps({file: faults(file, schema) for file in json.load(sys.stdin)}))


if __name__ == "__main__":
    main()
