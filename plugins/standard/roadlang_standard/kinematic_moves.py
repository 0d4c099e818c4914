"""Slow maneuvers whose tires do not slip: the rear axle goes where the vehicle points."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Neighbors, ObservationBatch
    from roadlang.geometry import Floats
    from roadlang.geometry.arrays import Booleans

SIDE = 0.1
"""Meters that remain between a vehicle and what it waits for."""


def arc_move(seen: ObservationBatch, distance: Floats, bend: Floats) -> Floats:
    """(N, 4) x, y, heading and 0 after the rear axle has gone (N,) meters, backward below 0, on a
    circle of curvature `bend` (N,), positive to the left as the vehicle goes forward."""
    import numpy as np

    half, turn = 0.5 * seen.wheelbase, distance * bend
    share = np.sinc(0.5 * turn / np.pi)
    rear_x = seen.x - half * np.cos(seen.heading)
    rear_y = seen.y - half * np.sin(seen.heading)
    rear_x = rear_x + distance * share * np.cos(seen.heading + 0.5 * turn)
    rear_y = rear_y + distance * share * np.sin(seen.heading + 0.5 * turn)
    heading = seen.heading + turn
    x, y = rear_x + half * np.cos(heading), rear_y + half * np.sin(heading)
    return np.stack((x, y, heading, np.zeros(len(x))), axis=1)


def lateral_reach(seen: ObservationBatch, pose: Floats) -> tuple[Floats, Floats]:
    """(N,) offsets of the leftmost and rightmost corner of vehicles at poses (N, 4), from the lines
    of the agents, which are taken to be straight there."""
    import numpy as np

    line = seen.heading - seen.heading_error
    across = np.cos(line) * (pose[:, 1] - seen.y) - np.sin(line) * (pose[:, 0] - seen.x)
    error = pose[:, 2] - line
    half = 0.5 * (seen.length * np.abs(np.sin(error)) + seen.width * np.abs(np.cos(error)))
    middle = seen.road_offset + across
    return middle + half, middle - half


def touches(seen: ObservationBatch, near: Neighbors, pose: Floats) -> Booleans:
    """(N,) whether agents at poses (N, 4) would come too close to others (N, K), closer than they
    are."""
    import numpy as np

    from roadlang.geometry import Footprints, separation

    others = Footprints(near.x, near.y, near.heading, near.length, near.width)
    now, then = (
        separation(
            Footprints(*(c[:, None] for c in (x, y, heading, seen.length, seen.width))), others
        )
        for x, y, heading in ((seen.x, seen.y, seen.heading), pose.T[:3])
    )
    return np.asarray((near.there & (then < SIDE) & (then < now - 1e-6)).any(axis=1))
