"""CommonRoad files, by its own reader, schema and collision checker. Runs with their Python.

Question: a list of files. Answer: by file, what is wrong with it.
"""

from __future__ import annotations

import json
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import commonroad
import numpy as np
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
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union

_LONG, _LONGEST = 6.0, 20.0
"""Meters: longer vehicles cut the inside of tight bends, wherever they are; none is longer."""
_NEAR, _SAME = 5.0, 1e-3
"""Meters within which lanelets matter, and within which they meet."""
_BESIDE, _LONG_BESIDE = 0.3, 2.0
"""Meters that a body may be beside lanelets in a junction, whose area is not all of lanelets; long
ones anywhere."""
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
        elif _sticks_out(obstacle, network, off_road):
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
    all of lanelets, it may be by `_BESIDE`: where its middle is in one, or what is out is nearest
    to one. Long vehicles may be by `_LONG_BESIDE` anywhere."""
    is_long = obstacle.obstacle_shape.length > _LONG
    for state in obstacle.prediction.trajectory.state_list:
        shape = obstacle.occupancy_at_time(state.time_step).shape
        if off_road.collide(create_collision_object(shape)):
            ids = network.find_lanelet_by_position([state.position])[0]
            types = [kind for id in ids for kind in network.find_lanelet_by_id(id).lanelet_type]
            in_junction = LaneletType.INTERSECTION in types
            for away, nearest_in_junction in _beside(shape.shapely_object, network):
                excused = is_long or in_junction or nearest_in_junction
                if away > (_LONG_BESIDE if is_long else _BESIDE) or not excused:
                    return True
    return False


def _beside(body: Any, network: Any) -> Iterator[tuple[float, bool]]:
    """How far each part of it that is on no lanelet is from one, and whether the nearest one is in
    a junction."""
    near = [
        (lanelet.polygon.shapely_object, LaneletType.INTERSECTION in lanelet.lanelet_type)
        for lanelet in network.lanelets
        if lanelet.polygon.shapely_object.distance(body) < _NEAR
    ]
    ends = [end for lanelet in network.lanelets for end in _beyond(lanelet)]
    lanes = unary_union([area.buffer(_SAME) for area in (*(area for area, _ in near), *ends)])
    out = body.difference(lanes)
    for part in getattr(out, "geoms", [out]):
        if not part.is_empty:
            away = max(lanes.distance(Point(corner)) for corner in part.exterior.coords)
            place = part.representative_point()
            least = min(area.distance(place) for area, _ in near)
            yield away, any(inside for area, inside in near if area.distance(place) < least + _SAME)


def _beyond(lanelet: Any) -> Iterator[Polygon]:
    """Where vehicles leave the map over its ends that lead nowhere."""
    for end, before, links in ((-1, -2, lanelet.successor), (0, 1, lanelet.predecessor)):
        if not links:
            ahead = lanelet.center_vertices[end] - lanelet.center_vertices[before]
            ahead *= _LONGEST / np.hypot(*ahead)
            left, right = lanelet.left_vertices[end], lanelet.right_vertices[end]
            yield Polygon((left, right, right + ahead, left + ahead)).buffer(0.0)


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
