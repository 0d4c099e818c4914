"""A drive in lock-step at the pace of the engine: each state is answered when it arrives."""

from __future__ import annotations

from ..net.protocol import Message
from ..net.session import Session
from ..net.telemetry import DriveState
from .driving import Controls, step_payload


class PacedDrive:
    """A drive that goes on whenever the engine is answered; in real time where the engine is.

    While it is not answered, it waits, and says again where all agents are: what is lost on the way
    is sent again without a clock here.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._state: bytes | None = None
        self._tick = -1
        self._answer = b""
        session.on_state = self._take
        session.send_json(Message.RUN, {"mode": "lockstep"}, "the start of the drive")

    def state(self, agents: int) -> DriveState | None:
        """Where so many agents are now, None where that is known or has not come."""
        payload, self._state = self._state, None
        if payload is None:
            return None
        state = DriveState.of(payload)
        if len(state.poses) != agents:
            return None
        if state.tick == self._tick:
            self._session.send_once(Message.STEP, self._answer)
            return None
        return state

    def answer(self, state: DriveState, controls: Controls, ticks: int) -> None:
        """Drive on for some ticks from a state."""
        self._tick = state.tick
        self._answer = step_payload(state.tick, ticks, controls)
        self._session.send_once(Message.STEP, self._answer)

    def look_again(self) -> None:
        """The scene has changed: what was heard before is of no use, the next state is new."""
        self._state, self._tick = None, -1

    def stop(self) -> None:
        """End the drive."""
        self._session.on_state = None
        self._session.send(Message.STOP, b"", "the end of the drive")

    def _take(self, payload: bytes) -> None:
        self._state = payload
