"""A session ends when the engine has heard so: until then it is held for nobody else."""

from __future__ import annotations

import json
from collections import deque

from roadlang_godot.net import protocol
from roadlang_godot.net.protocol import Message
from roadlang_godot.net.session import Session


class TalkativeEngine:
    """What an engine sends back that has much to complain about before it reads the goodbye."""

    def __init__(self, complaints: int) -> None:
        welcome = json.dumps({"session": 7}).encode()
        self.waiting = deque([protocol.pack(Message.WELCOME, 7, 0, welcome)])
        self.complaints = complaints
        self.said_goodbye = self.is_closed = False

    def send(self, datagram: bytes) -> None:
        frame = protocol.unpack(datagram)
        assert frame is not None
        if frame.type == Message.BYE:
            assert not self.said_goodbye, "the answer was not heard"
            complaint = protocol.pack(Message.ERROR, 7, 0, b"{}")
            self.waiting.extend([complaint] * self.complaints)
            self.waiting.append(protocol.pack(Message.BYE, 7, 0, b""))
            self.said_goodbye = True

    def receive(self, timeout: float) -> list[bytes]:
        return [self.waiting.popleft()] if self.waiting else []

    def close(self) -> None:
        self.is_closed = True


def test_a_goodbye_is_waited_for_whatever_else_is_said_before_it() -> None:
    link = TalkativeEngine(complaints=500)
    Session(link).close()
    assert link.is_closed
    assert not link.waiting


def test_an_engine_that_has_ended_is_not_waited_for() -> None:
    link = TalkativeEngine(complaints=0)
    running = [True]
    session = Session(link, ending=lambda: "" if running[0] else "its process has ended")
    running[0] = False
    session.close()
    assert link.is_closed
    assert not link.said_goodbye
