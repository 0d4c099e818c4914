"""Datagrams over UDP, to an engine that is not there yet."""

from __future__ import annotations

import socket
from types import SimpleNamespace

import pytest

from roadlang_godot.net import link_udp
from roadlang_godot.net.link_udp import UdpLink


def test_who_waits_for_an_engine_does_not_ask_without_a_pause(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where nobody listens the system refuses each datagram at once."""
    slept: list[float] = []
    monkeypatch.setattr(link_udp, "time", SimpleNamespace(sleep=slept.append))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as closed:
        closed.bind(("127.0.0.1", 0))
        port = closed.getsockname()[1]
    link = UdpLink("127.0.0.1", port)
    link.send(b"hello")
    assert link.receive(0.25) == []
    assert slept == [0.25]
    link.close()
