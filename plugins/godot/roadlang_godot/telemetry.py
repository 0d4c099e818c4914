"""What the engine reports of each agent at each tick, as one numpy record."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

RECORD = np.dtype(
    [
        ("tick", "<u4"),
        ("world", "<u2"),
        ("agent", "<u2"),
        ("wheels", "u1"),
        ("contacts", "u1"),
        ("in_charge", "i1"),
        ("at_end", "u1"),
        ("x", "<f4"),
        ("y", "<f4"),
        ("z", "<f4"),
        ("heading", "<f4"),
        ("speed", "<f4"),
        ("velocity_x", "<f4"),
        ("velocity_y", "<f4"),
        ("yaw_rate", "<f4"),
        ("steering", "<f4"),
        ("command", "<f4"),
        ("station", "<f4"),
        ("cross_track_error", "<f4"),
        ("progress", "<f4"),
    ]
)
"""x east, y north, z up in the engine's frame (meters), heading in radians from east; `wheels` are
bits of those on the ground, `contacts` the bodies touched, not counting the ground."""

Records = NDArray[Any]

STATE_HEADER = 8


def records(payload: bytes) -> Records:
    """The records of a TRACE message."""
    length = len(payload) // RECORD.itemsize * RECORD.itemsize
    return np.frombuffer(payload[:length], dtype=RECORD)


def of_agent(trace: Records, agent: int, world: int = 0) -> Records:
    """One agent's records, in order of time."""
    return np.asarray(trace[(trace["agent"] == agent) & (trace["world"] == world)])
