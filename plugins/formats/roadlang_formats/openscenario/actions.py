"""The actions of OpenSCENARIO that roadlang's controllers become."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from ..opendrive.elements import put
from .positions import Place

if TYPE_CHECKING:
    from numpy.typing import NDArray

Action = Callable[[Element], None]
"""Adds what is inside a `PrivateAction` element."""


def teleport(place: Place) -> Action:
    """Put an entity somewhere."""

    def write(parent: Element) -> None:
        place.put(put(parent, "TeleportAction"))

    return write


def at_speed(speed: float) -> Action:
    """Be at a speed at once, m/s."""
    return to_speed(speed, "step", "time", 0.0)


def to_speed(speed: float, shape: str, dimension: str, value: float) -> Action:
    """Change to a speed: within seconds (`time`), meters (`distance`), or at m/s^2 (`rate`)."""

    def write(parent: Element) -> None:
        action = _speed_action(parent, shape, dimension, value)
        put(put(action, "SpeedActionTarget"), "AbsoluteTargetSpeed", value=speed)

    return write


def to_speed_beside(other: str, faster: float, rate: float) -> Action:
    """Change to `faster` m/s more than the speed of another entity, by `rate` m/s^2."""

    def write(parent: Element) -> None:
        action = _speed_action(parent, "linear", "rate", rate)
        put(
            put(action, "SpeedActionTarget"),
            "RelativeTargetSpeed",
            entityRef=other,
            value=faster,
            speedTargetValueType="delta",
            continuous="false",
        )

    return write


def _speed_action(parent: Element, shape: str, dimension: str, value: float) -> Element:
    action = put(put(parent, "LongitudinalAction"), "SpeedAction")
    put(
        action,
        "SpeedActionDynamics",
        dynamicsShape=shape,
        dynamicsDimension=dimension,
        value=value,
        followingMode="position",
    )
    return action


def speed_profile(entries: Sequence[tuple[float, float]]) -> Action:
    """Follow speeds (m/s), each reached so many seconds after the one before."""

    def write(parent: Element) -> None:
        found = put(put(parent, "LongitudinalAction"), "SpeedProfileAction")
        found.set("followingMode", "position")
        for speed, time in entries:
            put(found, "SpeedProfileEntry", speed=speed, time=time)

    return write


def lane_change(
    dimension: str, value: float, absolute: int | None, relative: tuple[str, int]
) -> Action:
    """Change to the lane with the id `absolute`, or to the one that is as many lanes to the left of
    the lane of an entity as `relative` says."""

    def write(parent: Element) -> None:
        action = put(put(parent, "LateralAction"), "LaneChangeAction")
        put(
            action,
            "LaneChangeActionDynamics",
            dynamicsShape="sinusoidal",
            dynamicsDimension=dimension,
            value=value,
            followingMode="position",
        )
        target = put(action, "LaneChangeTarget")
        if absolute is not None:
            put(target, "AbsoluteTargetLane", value=absolute)
        else:
            put(target, "RelativeTargetLane", entityRef=relative[0], value=relative[1])

    return write


def assign_route(name: str, places: Sequence[Place], closed: bool) -> Action:
    """Drive by waypoints."""

    def write(parent: Element) -> None:
        action = put(put(parent, "RoutingAction"), "AssignRouteAction")
        route = put(action, "Route", name=name, closed="true" if closed else "false")
        for place in places:
            place.put(put(route, "Waypoint", routeStrategy="shortest"), turned=False)

    return write


def follow_trajectory(
    name: str,
    times: NDArray[np.float64],
    poses: NDArray[np.float64],
    absolute: bool,
) -> Action:
    """Be at poses (n, 3), x, y and heading, at times (n,): of the simulation, or since the action
    has begun."""

    def write(parent: Element) -> None:
        action = put(put(parent, "RoutingAction"), "FollowTrajectoryAction")
        reference = put(put(action, "TrajectoryRef"), "Trajectory", name=name, closed="false")
        line = put(put(reference, "Shape"), "Polyline")
        for time, pose in zip(times.tolist(), poses.tolist(), strict=True):
            vertex = put(line, "Vertex", time=time)
            Place(*pose).put(vertex)
        put(
            put(action, "TimeReference"),
            "Timing",
            domainAbsoluteRelative="absolute" if absolute else "relative",
            scale=1.0,
            offset=0.0,
        )
        put(action, "TrajectoryFollowingMode", followingMode="position")

    return write
