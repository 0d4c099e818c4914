"""What follows from how far agents are along their lines: formulas of columns (..., N)."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Booleans, Floats
from .arrivals import ARRIVED


def station(along: Floats, length: Floats, backward: Booleans) -> Floats:
    """(..., N) arc lengths along roads that are `length` meters long, within their ends."""
    within = np.minimum(np.maximum(along, 0.0), length)
    found: Floats = np.where(backward, length - within, within)
    return found


def at_end(
    along: Floats, traveled: Floats, end: Floats, has_road: Booleans, laps: Booleans | None,
    length: Floats,
) -> Booleans:  # fmt: skip
    """(..., N) who has arrived at the end of its line, or has gone all around. `laps`: whose line
    ends where it begins, None where nobody's does."""
    arrived = end - along < ARRIVED
    if laps is not None:
        arrived = np.where(laps, traveled >= length, arrived)
    found: Booleans = has_road & arrived
    return found


def progress(
    along: Floats, traveled: Floats, length: Floats, has_road: Booleans, closed: Booleans,
    arrived: Booleans,
) -> Floats:  # fmt: skip
    """(..., N) share of the line: of an open one up to here, of a closed one since the start."""
    so_far = np.where(closed, traveled, np.maximum(along, 0.0))
    share: Floats = np.where(has_road, np.where(arrived, 1.0, so_far / length), 0.0)
    return share
