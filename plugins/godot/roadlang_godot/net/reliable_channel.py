"""Reliable delivery over datagrams that may be lost, doubled or out of order.

The same rules as `godot_backend/net/reliable_channel.gd`: each side numbers its messages from 1,
the other acknowledges "everything up to n" and a mask of the 64 that follow, and what is not
acknowledged is sent again. Messages are handed on as they come, each exactly once.
"""

from __future__ import annotations

import struct
from collections import deque
from dataclasses import dataclass
from math import inf

from .protocol import WINDOW

FIRST_RESEND = 0.05
LAST_RESEND = 0.2
MASK_BITS = 64
OVERTAKEN = 4
"""A message that this many later ones have overtaken is sent again at once."""

_ACK = struct.Struct("<IQ")
_FARTHEST = 2048


@dataclass(slots=True)
class Flight:
    """A message on its way. Times are seconds of one monotonic clock."""

    type: int
    payload: bytes
    label: str
    first_sent: float
    resend_at: float
    wait: float
    overtaken: int = 0


class Channel:
    """One side's bookkeeping; it neither owns a socket nor reads a clock."""

    def __init__(self, window: int = WINDOW) -> None:
        self.window = window
        self.resent = 0
        self._next = 1
        self._waiting: deque[tuple[int, bytes, str]] = deque()
        self._flying: dict[int, Flight] = {}
        self._received = 0
        self._beyond: set[int] = set()
        self._ack_at_next = False
        self._has_progress, self._last_progress = False, -inf

    def offer(self, type: int, payload: bytes, label: str = "") -> None:
        """Take a message for sending; `label` names it where it never arrives."""
        self._waiting.append((type, payload, label))

    def to_send(self, now: float) -> list[tuple[int, int, bytes]]:
        """What is to be sent now, as (type, sequence number, payload)."""
        out = []
        for seq, flight in self._flying.items():
            if now >= flight.resend_at:
                flight.wait = min(2 * flight.wait, LAST_RESEND)
                flight.resend_at = now + flight.wait
                flight.overtaken = 0
                self.resent += 1
                out.append((flight.type, seq, flight.payload))
        while self._waiting and len(self._flying) < self.window:
            type, payload, label = self._waiting.popleft()
            seq, self._next = self._next, self._next + 1
            self._flying[seq] = Flight(type, payload, label, now, now + FIRST_RESEND, FIRST_RESEND)
            out.append((type, seq, payload))
        return out

    def next_due(self) -> float:
        """When the next message is to be sent again; infinity if none is unacknowledged."""
        return min((f.resend_at for f in self._flying.values()), default=inf)

    def acknowledged(self, payload: bytes) -> None:
        """Take an acknowledgment; anything else is ignored."""
        if len(payload) != _ACK.size:
            return
        upto, mask = _ACK.unpack(payload)
        arrived = [
            seq
            for seq in self._flying
            if seq <= upto or (seq - upto <= MASK_BITS and mask >> (seq - upto - 1) & 1)
        ]
        for seq in arrived:
            del self._flying[seq]
        self._has_progress |= bool(arrived)
        newest = max(arrived, default=0)
        for seq, flight in self._flying.items():
            if seq < newest:
                flight.overtaken += 1
                if flight.overtaken == OVERTAKEN:
                    flight.resend_at = 0.0

    def accept(self, seq: int) -> bool:
        """Whether this number is new; records it."""
        self._ack_at_next = True
        if seq <= self._received or seq in self._beyond or seq > self._received + _FARTHEST:
            return False
        self._beyond.add(seq)
        while self._received + 1 in self._beyond:
            self._received += 1
            self._beyond.remove(self._received)
        return True

    def take_ack(self) -> bytes:
        """The acknowledgment to send, empty if there is none."""
        if not self._ack_at_next:
            return b""
        self._ack_at_next = False
        ahead = (seq - self._received - 1 for seq in self._beyond)
        return _ACK.pack(self._received, sum(1 << bit for bit in ahead if bit < MASK_BITS))

    def overdue(self, now: float, patience: float) -> list[str]:
        """Labels of the messages that have been on their way for longer than `patience`, where no
        other has arrived meanwhile."""
        if self._has_progress:
            self._has_progress, self._last_progress = False, now
        if now - self._last_progress <= patience:
            return []
        late = [f for f in self._flying.values() if now - f.first_sent > patience]
        return [flight.label or f"message {flight.type:#04x}" for flight in late]

    @property
    def idle(self) -> bool:
        """Whether everything offered has arrived."""
        return not self._waiting and not self._flying
