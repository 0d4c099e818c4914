"""Which of Scenic's own conditions on a scene this one meets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Curve, Footprints, close_pairs, separation

from ..surfaces.built import built_roads

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, SceneRoad

_INSIDE = 0.2
"""Meters of lane that must be left beside a vehicle: Scenic's lanes have straight pieces."""
_APART = 0.05
"""Meters between two that do not touch."""


def on_lanes(scene: Scene, actors: Sequence[SceneActor]) -> frozenset[str]:
    """Names of those whose footprint lies wholly on the drivable lanes of a road, not in a
    junction."""
    roads = {road.name: road for road in built_roads(scene)}
    curves: dict[str, Curve] = {}
    found = []
    for actor in actors:
        road = roads.get(actor.road or "")
        if road is None:
            continue
        if road.name not in curves:
            points = np.column_stack((road.x, road.y))
            curves[road.name] = Curve.hermite(points, road.heading, closed=road.closed)
        if _is_on(actor, road, curves[road.name]):
            found.append(actor.name)
    return frozenset(found)


def touching(actors: Sequence[SceneActor]) -> frozenset[str]:
    """Names of those whose footprints overlap another's."""
    if len(actors) < 2:
        return frozenset()
    rows = np.array([(a.x, a.y, a.heading, a.length, a.width) for a in actors])
    feet = Footprints(*rows.T)
    first, second = close_pairs(feet, feet, _APART)
    first, second = first[first < second], second[first < second]
    close = separation(feet.take(first), feet.take(second)) < _APART
    return frozenset(actors[row].name for row in {*first[close], *second[close]})


def _is_on(actor: SceneActor, road: SceneRoad, curve: Curve) -> bool:
    pose = np.array([[actor.x], [actor.y], [actor.heading], [actor.length], [actor.width]])
    s, away = curve.project(Footprints(*pose).corners[0])
    s = s * (road.length / curve.length)
    left, right = road.cross_section().drivable_extent(s)
    across = (away < left - _INSIDE) & (away > right + _INSIDE)
    if road.closed:
        return bool(across.all())
    start, stop = road.trim[0] + _INSIDE, road.length - road.trim[1] - _INSIDE
    return bool((across & (s > start) & (s < stop)).all())
