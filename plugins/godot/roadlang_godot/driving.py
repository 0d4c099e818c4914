"""Drives what was built: freely inside the engine, or step by step from Python."""

from __future__ import annotations

import json
import struct
import time
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from roadlang.api import Code

from .faults import fault
from .protocol import Message
from .session import Session
from .telemetry import STATE_HEADER, Records, records

_RESEND = 0.02
_STEP = struct.Struct("<IHH")
_CONTROL = struct.Struct("<HHff")

Controls = Mapping[tuple[int, int], tuple[float, float]]
"""(world, agent) to (steering angle, acceleration)."""


@dataclass(frozen=True, slots=True)
class GodotDrive:
    """A finished drive: all records, at which tick it ended, and why."""

    trace: Records
    ticks: int
    reason: str


def run(session: Session, ticks: int, *, every: int = 1, stop_at_end: bool = False) -> GodotDrive:
    """Let the engine drive for `ticks` physics ticks, recording one in `every`.

    With `stop_at_end` the drive ends when every agent has reached the end of its path.
    """
    settings = {"mode": "free", "ticks": ticks, "every": every, "stop_at_end": stop_at_end}
    session.send_json(Message.RUN, settings, "the start of the drive")
    parts: list[Records] = []
    while (done := session.take(Message.DONE)) is None:
        session.pump(0.02)
        _gather(session, parts)
    end = json.loads(done)
    # The end may overtake what was recorded before it.
    while sum(map(len, parts)) < int(end["records"]):
        session.pump(0.02)
        _gather(session, parts)
    trace = np.concatenate(parts) if parts else records(b"")
    # Messages come in any order; records tell theirs.
    trace = trace[np.lexsort((trace["agent"], trace["world"], trace["tick"]))]
    return GodotDrive(trace, int(end["tick"]), str(end["reason"]))


def _gather(session: Session, parts: list[Records]) -> None:
    while (part := session.take(Message.TRACE)) is not None:
        parts.append(records(part))


class LockStep:
    """A drive that waits for Python at every step. Use as a context manager."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._state: bytes | None = None
        session.send_json(Message.RUN, {"mode": "lockstep"}, "the start of the drive")
        session.flush()
        session.on_state = self._take
        self.tick, self.at_end, self.state = self._await(0, None)

    def __enter__(self) -> LockStep:
        return self

    def __exit__(self, *_: object) -> None:
        self._session.on_state = None
        self._session.send(Message.STOP, b"", "the end of the drive")
        self._session.expect(Message.DONE)

    def step(self, controls: Controls, ticks: int = 1) -> Records:
        """Hold these controls for some ticks; returns the records of all agents after them.

        Agents without controls go on as their own controllers want.
        """
        payload = _STEP.pack(self.tick, ticks, len(controls)) + b"".join(
            _CONTROL.pack(world, agent, steer, acceleration)
            for (world, agent), (steer, acceleration) in controls.items()
        )
        self.tick, self.at_end, self.state = self._await(self.tick + ticks, payload)
        return self.state

    def _take(self, payload: bytes) -> None:
        self._state = payload

    def _await(self, tick: int, request: bytes | None) -> tuple[int, bool, Records]:
        deadline = time.monotonic() + 2 * self._session.patience
        while time.monotonic() < deadline:
            if request is not None:
                self._session.send_once(Message.STEP, request)
            resend = time.monotonic() + _RESEND
            while time.monotonic() < resend:
                self._session.pump(_RESEND)
                self._session.take(Message.DONE)
                if self._state is None:
                    continue
                payload, self._state = self._state, None
                now, ended = struct.unpack_from("<II", payload)
                if now == tick:
                    return now, bool(ended), records(payload[STATE_HEADER:])
        raise fault(Code.GODOT_DISCONNECTED, reason=f"no state for step {tick}")
