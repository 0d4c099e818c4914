"""What the engine reports: agents at each tick, where they are now, and what they touched."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field
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
bits of those on the ground, `contacts` the agents and objects touched so far."""

POSE = np.dtype(
    [("x", "<f4"), ("y", "<f4"), ("heading", "<f4"), ("speed", "<f4"), ("steering", "<f4")]
)
"""Where an agent is in a state of a drive in lock-step: as in `RECORD`."""

CONTACT = np.dtype(
    [
        ("tick", "<u4"),
        ("world", "<u2"),
        ("agent", "<u2"),
        ("other", "<u4"),
        ("index", "<i4"),
        ("speed", "<f4"),
    ]
)
"""`agent` has touched something for the first time: the agent `other`, or where `index` is not -1
the object of that place in the thing `other`; `speed` of one relative to the other just before."""

Records = NDArray[Any]

_STATE = struct.Struct("<IHH")


HAND = np.dtype([("world", "<u2"), ("agent", "<u2"), ("steering", "<f4"), ("acceleration", "<f4")])


@dataclass(frozen=True, slots=True)
class DriveState:
    """Where all agents are at a tick, in the order of their numbers, and what they have touched
    since the state before."""

    tick: int
    poses: Records
    contacts: Records
    hands: Records = field(default_factory=lambda: np.empty(0, HAND))
    """what humans want, of each agent that is driven by hand"""

    @classmethod
    def of(cls, payload: bytes) -> DriveState:
        """That of a STATE message."""
        tick, agents, contacts = _STATE.unpack_from(payload)
        at = _STATE.size + agents * POSE.itemsize
        return cls(
            tick,
            np.frombuffer(payload, POSE, agents, _STATE.size),
            np.frombuffer(payload, CONTACT, contacts, at),
            np.frombuffer(payload, HAND, -1, at + contacts * CONTACT.itemsize),
        )


def records(payload: bytes, dtype: np.dtype[Any] = RECORD) -> Records:
    """The records of a TRACE or CONTACTS message."""
    length = len(payload) // dtype.itemsize * dtype.itemsize
    return np.frombuffer(payload[:length], dtype=dtype)


def of_agent(trace: Records, agent: int, world: int = 0) -> Records:
    """One agent's records, in order of time."""
    return np.asarray(trace[(trace["agent"] == agent) & (trace["world"] == world)])
