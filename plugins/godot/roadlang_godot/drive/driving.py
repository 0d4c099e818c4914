"""Drives what was built: freely inside the engine, or step by step from Python."""

from __future__ import annotations

import json
import struct
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from ..net.protocol import Message
from ..net.session import Session
from ..net.telemetry import CONTACT, RECORD, DriveState, Records, records

_RESEND = 0.02
_LONGEST_HOLD = 60
"""Ticks: longer steps are taken in parts, each of which shows that the engine is alive."""
_STEP = struct.Struct("<IHH")
_CONTROL = struct.Struct("<HHIffff")


class ControlForm(IntEnum):
    """What the four numbers of an `EngineControl` are."""

    STEER = 1
    """0, 0, steering angle, acceleration"""
    FACE = 2
    """0, 0, heading, acceleration: of who is on foot"""
    POSE = 3
    """x, y, heading, speed at the end of the step"""
    LEAVE = 4
    """0, 0, steering angle, acceleration: nobody sees or touches it any more"""


@dataclass(frozen=True, slots=True)
class EngineControl:
    """What an agent is to do until the next step, in the engine's coordinates."""

    form: ControlForm
    numbers: tuple[float, float, float, float]

    @classmethod
    def steer(cls, steering: float, acceleration: float) -> EngineControl:
        """A steering angle and an acceleration."""
        return cls(ControlForm.STEER, (0.0, 0.0, steering, acceleration))


Controls = Mapping[int, EngineControl]
"""By the numbers of agents."""


@dataclass(frozen=True, slots=True)
class GodotDrive:
    """A finished drive: all records, what was touched, at which tick it ended, and why."""

    trace: Records
    contacts: Records
    ticks: int
    reason: str


def run(session: Session, ticks: int, *, every: int = 1, stop_at_end: bool = False) -> GodotDrive:
    """Let the engine drive for `ticks` physics ticks, recording one in `every`.

    With `stop_at_end` the drive ends when every agent has reached the end of its path.
    """
    settings = {"mode": "free", "ticks": ticks, "every": every, "stop_at_end": stop_at_end}
    session.send_json(Message.RUN, settings, "the start of the drive")
    parts = {RECORD: [records(b"")], CONTACT: [records(b"", CONTACT)]}
    while (done := session.take(Message.DONE)) is None:
        session.pump(0.02)
        _gather(session, parts)
    end = json.loads(done)
    # The end may overtake what was recorded before it.
    counts = {RECORD: int(end["records"]), CONTACT: int(end["contacts"])}
    while any(sum(map(len, parts[dtype])) < count for dtype, count in counts.items()):
        session.pump(0.02)
        _gather(session, parts)
    trace, contacts = (np.concatenate(parts[dtype]) for dtype in (RECORD, CONTACT))
    # Messages come in any order; records tell theirs.
    trace = trace[np.lexsort((trace["agent"], trace["world"], trace["tick"]))]
    contacts = contacts[np.lexsort((contacts["agent"], contacts["world"], contacts["tick"]))]
    return GodotDrive(trace, contacts, int(end["tick"]), str(end["reason"]))


def _gather(session: Session, parts: Mapping[np.dtype[np.void], list[Records]]) -> None:
    for message, dtype in ((Message.TRACE, RECORD), (Message.CONTACTS, CONTACT)):
        while (part := session.take(message)) is not None:
            parts[dtype].append(records(part, dtype))


def step_payload(tick: int, ticks: int, controls: Controls, world: int = 0) -> bytes:
    """The STEP that holds controls for some ticks."""
    packed = b"".join(
        _CONTROL.pack(world, agent, control.form, *control.numbers)
        for agent, control in controls.items()
    )
    return _STEP.pack(tick, ticks, len(controls)) + packed


class LockStep:
    """A drive that waits for Python at every step. Use as a context manager."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._state: bytes | None = None
        session.send_json(Message.RUN, {"mode": "lockstep"}, "the start of the drive")
        session.flush()
        session.on_state = self._take
        self.state = self._await(0, None)

    def __enter__(self) -> LockStep:
        return self

    def __exit__(self, *_: object) -> None:
        self._session.on_state = None
        self._session.send(Message.STOP, b"", "the end of the drive")
        self._session.expect(Message.DONE)

    @property
    def tick(self) -> int:
        """Physics ticks since the start."""
        return self.state.tick

    def step(self, controls: Controls, ticks: int = 1, world: int = 0) -> DriveState:
        """Hold these controls for some ticks; returns the state after them.

        Agents without controls go on as their own controllers want.
        """
        payload = step_payload(self.tick, ticks, controls, world)
        self.state = self._await(self.tick + ticks, payload)
        return self.state

    def hold(self, ticks: int) -> Iterable[DriveState]:
        """Let all agents go on as their own controllers want, for some ticks in parts."""
        while ticks > 0:
            part = min(ticks, _LONGEST_HOLD)
            yield self.step({}, part)
            ticks -= part

    def _take(self, payload: bytes) -> None:
        self._state = payload

    def _await(self, tick: int, request: bytes | None) -> DriveState:
        # An engine that is lost, or not heard for too long, ends `pump` with an error.
        while True:
            if request is not None:
                self._session.send_once(Message.STEP, request)
            resend = time.monotonic() + _RESEND
            while time.monotonic() < resend:
                self._session.pump(_RESEND)
                self._session.take(Message.DONE)
                if self._state is None:
                    continue
                payload, self._state = self._state, None
                state = DriveState.of(payload)
                if state.tick == tick:
                    return state
