"""What a batch of agents sees: columns that are computed when a controller first looks at them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...ir.observation import ObservationBatch
from ..surroundings.nearest import nearest

EVERYONE = slice(None)
_set = object.__setattr__  # observations are frozen


class LazyObservations(ObservationBatch):
    """The observations of the agents `chosen` in a view. It holds while the world stands still."""

    __slots__ = ("chosen", "rows", "view")

    view: Any
    """a `View`, which this file must not import"""
    chosen: Integers
    rows: Any
    """the same as an index: a slice where they are all agents, as that is found faster"""

    def __init__(self, view: Any, chosen: Integers) -> None:
        everyone = len(chosen) == len(view.world.present)
        _set(self, "view", view)
        _set(self, "chosen", chosen)
        _set(self, "rows", EVERYONE if everyone else chosen)
        _set(self, "step", view.step)

    def numbers(self, names: Sequence[str]) -> list[list[float]]:
        """Columns of numbers as lists, of a view that is looked at but once."""
        if self.view.sensing is not None:
            return [getattr(self, name).tolist() for name in names]
        view, rows = self.view, self.rows
        return [
            (_COLUMNS[name](view)[rows] if name in _COLUMNS else _DERIVED[name](self)).tolist()
            for name in names
        ]

    if not TYPE_CHECKING:  # where it would hide what is no member

        def __getattr__(self, name: str) -> Any:
            view, column = self.view, _COLUMNS.get(name)
            if column is not None:
                value: Any = column(view)[self.rows]
                if self.rows is EVERYONE and isinstance(value, np.ndarray):
                    value = value.copy()  # a controller may change it, as that of some agents
            elif name in _DERIVED:
                value = _DERIVED[name](self)
            else:
                raise AttributeError(f"an observation has no member `{name}`")
            if view.sensing is not None and name in view.replaced:
                seen = view.replaced[name][self.rows]
                value = np.where(np.isnan(seen), value, seen)
            _set(self, name, value)
            return value


_COLUMNS: Mapping[str, Callable[[Any], Floats]] = {
    "time": lambda view: view.world.age,
    "agent": lambda view: view.world.names,
    "x": lambda view: view.poses.x,
    "y": lambda view: view.poses.y,
    "heading": lambda view: view.poses.heading,
    "speed": lambda view: view.world.motion.speed,
    "cross_track_error": lambda view: view.world.cross_track_error,
    "station": lambda view: view.world.station,
    "wheelbase": lambda view: view.world.bodies.wheelbase,
    "road_offset": lambda view: view.world.motion.offset,
    "length": lambda view: view.world.bodies.length,
    "width": lambda view: view.world.bodies.width,
    "max_steering": lambda view: view.world.bodies.max_steering,
    "yaw_rate": lambda view: view.world.motion.yaw_rate,
    "acceleration": lambda view: view.world.motion.acceleration,
    "contacts": lambda view: view.world.contacts,
    "traveled": lambda view: view.world.traveled,
}
"""(N,) of all agents."""


def _heading_error(seen: LazyObservations) -> Floats:
    motion = seen.view.world.motion
    return np.asarray(np.arctan2(motion.sine[seen.rows], motion.cosine[seen.rows]))


def _road_width(seen: LazyObservations) -> Floats:
    has_road = seen.view.world.has_road[seen.rows]
    return np.where(has_road, seen.view.poses.road_width[seen.rows], math.inf)


def _lane(quantity: str) -> Callable[[LazyObservations], Callable[..., Floats]]:
    def found(seen: LazyObservations) -> Callable[..., Floats]:
        view, chosen = seen.view, seen.chosen
        return lambda which: view.of_lane(chosen, which, quantity)

    return found


def _stop_ahead(seen: LazyObservations) -> Callable[[], Floats]:
    view, chosen = seen.view, seen.chosen
    return lambda: view.right_of_way(chosen)[0]


def _right_of_way(seen: LazyObservations) -> Callable[..., tuple[Floats, ...]]:
    view, chosen = seen.view, seen.chosen
    return lambda p, a, passing=None: view.right_of_way(chosen, (p, a), passing)


_DERIVED: Mapping[str, Callable[[LazyObservations], Any]] = {
    "steering": lambda seen: np.arctan(seen.view.world.motion.tangent[seen.rows]),
    "heading_error": _heading_error,
    "road_width": _road_width,
    "line_ahead": lambda seen: partial(seen.view.line_ahead, seen.rows),
    "curvatures_ahead": lambda seen: partial(seen.view.curvatures_ahead, seen.rows),
    "path_ahead": lambda seen: partial(seen.view.path_ahead, seen.rows),
    "speed_for_bends": lambda seen: partial(
        seen.view.surroundings.bends.at, seen.view.world, seen.rows
    ),
    "vehicle_ahead": lambda seen: partial(seen.view.vehicle_ahead, seen.rows),
    "moving_ahead": lambda seen: partial(seen.view.moving_ahead, seen.chosen),
    "acceleration_ahead": lambda seen: partial(seen.view.acceleration_ahead, seen.rows),
    "obstacle_ahead": lambda seen: partial(seen.view.objects.ahead, seen.rows),
    "row_ahead": lambda seen: partial(seen.view.objects.row, seen.rows),
    "touches_ahead": lambda seen: partial(
        seen.view.objects.touched, seen.view.path_ahead, seen.chosen
    ),
    "comes_toward": lambda seen: partial(seen.view.objects.coming, seen.chosen),
    "lanes_beside": lambda seen: partial(seen.view.objects.lanes, seen.chosen),
    "lane_end": lambda seen: partial(seen.view.lane_end, seen.chosen),
    "lane_place": lambda seen: partial(seen.view.lane_place, seen.chosen),
    "offset_of_lane": _lane("middles"),
    "direction_of_lane": _lane("direction"),
    "speed_limit_ahead": lambda seen: partial(seen.view.speed_limit_ahead, seen.chosen),
    "sensors": lambda seen: seen.view.readings(seen.chosen),
    "stop_ahead": _stop_ahead,
    "right_of_way": _right_of_way,
    "junction_ahead": lambda seen: partial(seen.view.junction_ahead, seen.chosen),
    "nearby": lambda seen: partial(seen.view.nearby, seen.chosen),
    "nearest": lambda seen: partial(nearest, seen.view.world, seen.view.poses, seen.chosen),
}
"""Of the chosen agents alone. None of them refers to the observations, which keep it: a step is
freed when the next one comes."""
