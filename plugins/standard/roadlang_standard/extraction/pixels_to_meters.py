"""From pixels to the world: what was found, as an `Extraction` in meters."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats

from .curves.even_points import even_points_of
from .legends.cell_links import is_square, joined_places
from .legends.legend import LegendObject
from .networks.directions import runs_forward
from .networks.doubtful_roads import doubts
from .networks.found_network import FoundNetwork, FoundRoad

if TYPE_CHECKING:
    from roadlang.api import Extraction, FoundObject, Picture
    from roadlang.geometry import Curve

_STEP, _APART = 2.0, 1e-6
"""Points of roads are at least `_STEP` pixels apart; nearer than `_APART` meters they are one."""
_WIDEST_CORNER = 2.0  # cells: more than a fillet of half a link has, so that each fills its cell


def extraction(
    picture: Picture,
    found: FoundNetwork,
    objects: Sequence[LegendObject] = (),
    remarks: Sequence[str] = (),
) -> Extraction:
    """The found roads as splines in meters, joined at nodes; doubtful ones are remarked on."""
    from roadlang.api import Extraction
    from roadlang.geometry import Edge, Node, RoadNetwork

    where = picture.to_world(found.nodes) if len(found.nodes) else found.nodes
    where = np.array(where, dtype=np.float64)
    degree = Counter(node for road in found.roads for node in (road.start, road.end))
    edges: list[Edge] = []
    errors: list[float] = []
    confidences: list[Floats] = []
    rings = [road.closed and degree[road.start] == 2 for road in found.roads]
    curves = _curves(picture, found, rings, where)
    for road, ring, curve in zip(found.roads, rings, curves, strict=True):
        if curve is not None:
            if ring:
                where[road.start] = curve.at(0.0)
            widths = np.maximum(road.widths * picture.scale, 1e-3)
            ids = (road.start, road.end)
            forward = runs_forward(road, found.directions)
            edges.append(
                Edge(len(edges) + 1, *ids, curve, widths, road.confidence, forward=forward)
            )
            errors.append(float(road.width_error * picture.scale))
            confidences.append(
                np.array([road.confidence]) if road.confidences is None else road.confidences
            )
    used = {node for edge in edges for node in (edge.start, edge.end)}
    nodes = tuple(Node(i, (float(x), float(y))) for i, (x, y) in enumerate(where) if i in used)
    return Extraction(
        RoadNetwork(nodes, tuple(edges)),
        tuple(_object(picture, object_) for object_ in objects),
        round(found.confidence, 4),
        (*remarks, *found.remarks, *_lone_cells(picture, found), *doubts(found, picture)),
        found.mask,
        tuple(errors),
        found.has_widths,
        confidences=tuple(confidences),
    )


def _curves(
    picture: Picture, found: FoundNetwork, rings: Sequence[bool], where: Floats
) -> list[Curve | None]:
    """The curve of each road, in meters; None for a road without length."""
    if found.method != "cells":
        return _splines(picture, found.roads, where)
    return [_through_cells(picture, *each) for each in zip(found.roads, rings, strict=True)]


def _through_cells(picture: Picture, road: FoundRoad, ring: bool) -> Curve | None:
    """Straight lines through centers of cells, each corner an arc between the sides of its cell.

    None for a road without length. A `ring` meets no other road, so its first corner is round too
    and it begins after it; any other loop keeps the corner at the junction that it leaves.
    """
    from roadlang.geometry import filleted

    if len(road.points) < 2:
        return None
    world = picture.to_world(road.points[:-1] if ring else road.points)
    return filleted(world, _WIDEST_CORNER * picture.scale, closed=ring)


def _splines(picture: Picture, roads: Sequence[FoundRoad], where: Floats) -> list[Curve | None]:
    """Splines through points about half a width apart; None for a road without length."""
    from roadlang.geometry import Curve

    lines = _between_nodes(picture, roads, where)
    found: list[Curve | None] = [
        Curve.through(line[:-1], closed=True) if road.closed and len(line) > 3 else None
        for road, line in zip(roads, lines, strict=True)
    ]
    opened = [i for i, road in enumerate(roads) if len(lines[i]) > 1 and not road.closed]
    curves = Curve.through_each([lines[index] for index in opened])
    for index, curve in zip(opened, curves, strict=True):
        found[index] = curve
    return found


def _between_nodes(picture: Picture, roads: Sequence[FoundRoad], where: Floats) -> list[Floats]:
    """Points (n, 2) of each road in meters, from node to node, none of them twice."""
    if not roads:
        return []
    steps = [max(_STEP, 0.5 * road.usual_width) for road in roads]
    lines = even_points_of([road.points for road in roads], steps)
    ends = np.cumsum([len(line) for line in lines])
    starts = ends - [len(line) for line in lines]
    world = picture.to_world(np.concatenate(lines))
    world[starts] = where[[road.start for road in roads]]
    world[ends - 1] = where[[road.end for road in roads]]
    apart = np.ones(len(world), bool)
    apart[1:] = np.hypot(*(world[1:] - world[:-1]).T) > _APART
    apart[starts] = True
    rows = [slice(*each) for each in zip(starts.tolist(), ends.tolist(), strict=True)]
    return [world[row] if apart[row].all() else world[row][apart[row]] for row in rows]


def _object(picture: Picture, drawn: LegendObject) -> FoundObject:
    from roadlang.api import FoundObject

    x, y = picture.to_world(np.array([[drawn.x, drawn.y]]))[0]
    scale = picture.scale
    turn = 0.0 if picture.north_up is None else picture.north_up.turn
    sides = drawn.length * scale, drawn.width * scale
    return FoundObject(drawn.kind, float(x), float(y), *sides, turn - drawn.heading)


def _lone_cells(picture: Picture, found: FoundNetwork) -> list[str]:
    """That what is no longer than wide is no road, with the places of at most five."""
    if found.method != "cells":
        return []
    lone = [place for place, near in joined_places(found.mask).items() if not near][:5]
    if not lone:
        return []
    where = picture.to_world(np.array([(column, row) for row, column in lone]) / 2)
    return [
        f"the four road cells around ({x:.4g} m, {y:.4g} m) have no neighbor: a road is longer "
        "than it is wide"
        if is_square(place)
        else f"the road cell at ({x:.4g} m, {y:.4g} m) has no neighbor: a road has at least two "
        "cells"
        for place, (x, y) in zip(lone, where, strict=True)
    ]
