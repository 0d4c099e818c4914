"""CommonRoad scenarios from above: lanelets, obstacles and where the planned vehicle starts."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from roadlang.geometry import Floats
from roadlang_standard.svg import palette

from ..map_xml import MapElement, MapFile
from .shapes import MOST_COORDINATE, PlanShape, Pose, joined, placed, rectangle

_PLANNED = (4.5, 1.8)
"""Meters, length and width: the file does not state those of the planned vehicle."""
_COLORS = {
    "sidewalk": palette.LANES["sidewalk"],
    "crosswalk": palette.LANES["sidewalk"],
    "bicycleLane": palette.LANES["bike"],
    "busLane": palette.LANES["bus"],
}
_OBSTACLES = {
    "staticObstacle": palette.OBJECT,
    "dynamicObstacle": palette.AGENTS[1],
    "environmentObstacle": palette.ROOF_LIGHT,
}


def shapes(file: MapFile) -> Iterator[PlanShape]:
    """Lanelets first."""
    for lanelet in file.root.all("lanelet"):
        left, right = (_line(file, lanelet, side) for side in ("leftBound", "rightBound"))
        kinds = [_COLORS.get(kind.text.strip()) for kind in lanelet.all("laneletType")]
        color = next((color for color in kinds if color), palette.SURFACE)
        label = f"lanelet {lanelet.attributes.get('id', '')}"
        yield PlanShape((joined(left, right),), color, label=label)
    for tag, color in _OBSTACLES.items():
        for obstacle in file.root.all(tag):
            outlines = tuple(_outlines(file, obstacle))
            if outlines:
                yield PlanShape(outlines, color, label=f"{tag} {obstacle.attributes.get('id', '')}")
    for problem in file.root.all("planningProblem"):
        pose = _pose(file, problem)
        if pose is not None:
            yield PlanShape((rectangle(*pose, *_PLANNED),), palette.AGENTS[0], label="planned")


def _line(file: MapFile, lanelet: MapElement, side: str) -> Floats:
    found = [_point(file, point) for point in lanelet.all(side, "point")]
    if len(found) < 2:
        raise file.fault(lanelet, f"this lanelet has no `{side}`")
    return np.array(found)


def _outlines(file: MapFile, obstacle: MapElement) -> Iterator[Floats]:
    """Shapes around where the obstacle is at the start; a shape has its own place in that."""
    pose = _pose(file, obstacle) or (0.0, 0.0, 0.0)
    for shape in obstacle.all("shape", "rectangle"):
        turn = 0.0 if shape.first("orientation") is None else _value(file, shape, "orientation")
        size = _value(file, shape, "length"), _value(file, shape, "width")
        yield placed(rectangle(*_center(file, shape), turn, *size), pose)
    for shape in obstacle.all("shape", "circle"):
        angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
        ring = np.column_stack((np.cos(angles), np.sin(angles))) * _value(file, shape, "radius")
        yield placed(np.array(_center(file, shape)) + ring, pose)
    for shape in obstacle.all("shape", "polygon"):
        corners = np.array([_point(file, point) for point in shape.all("point")]).reshape(-1, 2)
        if len(corners) > 2:
            yield placed(corners, pose)


def _center(file: MapFile, shape: MapElement) -> tuple[float, float]:
    center = shape.first("center")
    return (0.0, 0.0) if center is None else _point(file, center)


def _pose(file: MapFile, owner: MapElement) -> Pose | None:
    """x, y and heading at the start."""
    point = owner.first("initialState", "position", "point")
    turned = owner.first("initialState", "orientation")
    if point is None:
        return None
    heading = (
        0.0 if turned is None or turned.first("exact") is None else _value(file, turned, "exact")
    )
    return *_point(file, point), heading


def _point(file: MapFile, point: MapElement) -> tuple[float, float]:
    return _value(file, point, "x"), _value(file, point, "y")


def _value(file: MapFile, parent: MapElement, name: str) -> float:
    """The number that is the text of a child. Raises RL479."""
    child = parent.first(name)
    try:
        found = float("nan" if child is None else child.text)
    except ValueError:
        found = float("nan")
    if not abs(found) <= MOST_COORDINATE:
        raise file.fault(child or parent, f"`{parent.tag}` has no number `{name}`")
    return found
