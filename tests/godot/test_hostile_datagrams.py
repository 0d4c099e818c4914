"""Noise, mutations and forged frames: the engine neither crashes nor floods its log."""

from __future__ import annotations

import contextlib
import json
import random
import socket
import struct
from collections.abc import Iterator
from itertools import product
from typing import Any

import pytest

from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.mounted_camera import MountedCamera
from roadlang_godot.engines.engine import Engine
from roadlang_godot.net import protocol
from roadlang_godot.net.protocol import Message
from tests.godot.godot_scenes import car, pieces, road, scene, straight
from tests.godot.test_building import begin, everything

pytestmark = pytest.mark.godot

MOST_LOG_LINES = 60


def hostile(chance: random.Random, session: int) -> bytes:
    """Noise, a spoilt frame, or a whole frame with a payload of nonsense."""
    kind = chance.random()
    size = chance.choice((0, 1, 12, 19, 20, 21, 60, 400, 1400, 9000))
    noise = chance.randbytes(size)
    if kind < 0.3:
        return noise
    type = chance.choice([*Message, chance.randrange(256)])
    if type in (Message.BYE, Message.BEGIN) and kind > 0.5:
        type = Message.SEGMENT
    prefix = struct.pack("<HHII", 0, 0, chance.randrange(1 << 32), chance.randrange(1 << 32))
    body = (prefix + noise)[: protocol.MAX_DATAGRAM - protocol.HEADER_BYTES]
    if chance.random() < 0.2:
        body = b'{"protocol":[1,1],"nonce":' + b"[" * chance.randrange(900) + b"}"
    seq = chance.choice((0, chance.randrange(1, 3000), chance.randrange(1 << 32)))
    frame = bytearray(protocol.pack(type, chance.choice((session, 0, 77)), seq, body))
    if kind < 0.6:
        frame[chance.randrange(len(frame))] ^= 1 << chance.randrange(8)
    return bytes(frame)


def bombard(engine: Engine, count: int, seed: int) -> None:
    """Send hostile datagrams from an address that holds the session."""
    chance = random.Random(seed)
    with engine.connect("fuzz") as session:
        begin(session, everything()[:10])
        number = session.welcome["session"]
        own: socket.socket = session._link._socket  # type: ignore[attr-defined]
        stranger = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        stranger.connect((engine.host, engine.port))
        for i in range(count):
            with contextlib.suppress(BlockingIOError, ConnectionError):
                (own if chance.random() < 0.5 else stranger).send(hostile(chance, number))
            if i % 40 == 39:
                session._link.receive(0.004)
        stranger.close()


@pytest.mark.parametrize(
    "count", [3_000, pytest.param(100_000, marks=pytest.mark.slow)], ids=["some", "many"]
)
def test_hostile_datagrams_harm_nothing(fresh_engine: Engine, count: int) -> None:
    bombard(fresh_engine, count, seed=count)
    assert fresh_engine.process.poll() is None
    printed = fresh_engine.output().splitlines()
    # Godot itself says so, with a backtrace, where a sender outruns it; the rest is ours.
    ours = [line for line in printed if not line.startswith((" ", "WARNING: Buffer full"))]
    assert len(ours) < MOST_LOG_LINES, "\n".join(ours[-60:])
    things = everything()
    with fresh_engine.connect("after") as session:
        begin(session, things)
        assert session.prove().parts == len(things)


WRONG: list[Any] = [None, "x", [], {}, [{}], True, 1e300, -1.0]
RUN = {"mode": "free", "ticks": 5, "every": 1, "stop_at_end": False}
LOOK = {"id": 1, "world": 0, "cameras": [1], "format": "png"}


def spoilt(document: dict[str, Any]) -> Iterator[bytes]:
    """A JSON object with each of its values replaced by others of wrong types and sizes."""
    for key, wrong in product(document, WRONG):
        yield json.dumps({**document, key: wrong}).encode()


def test_values_of_wrong_types_are_no_script_errors(fresh_engine: Engine) -> None:
    ego = car("ego", road("main", pieces(straight(90))), 10.0)
    drawn = scene(road("main", pieces(straight(90))), agents=[ego])
    layout = layout_of(drawn)
    camera = MountedCamera("ego").part(1, 1)
    with fresh_engine.connect("types") as session:
        begin(session, list(layout.parts))
        number, revision = session.welcome["session"], 100
        for part in [*layout.parts, camera]:
            if part.kind in (Message.AGENT, Message.WORLD, Message.CAMERA):
                for body in spoilt(json.loads(part.body)):
                    revision += 1
                    head = struct.pack("<HHII", 0, 0, part.id, revision)
                    session._link.send(protocol.pack(part.kind, number, 0, head + body))
                session._link.receive(0.05)
        for type, wish in ((Message.RUN, RUN), (Message.EXPORT, LOOK), (Message.LOOK, LOOK)):
            for body in spoilt(wish):
                session._link.send(protocol.pack(type, number, 0, body))
            session._link.receive(0.05)
    with fresh_engine.connect("after") as session:
        begin(session, list(layout.parts))
        assert session.prove().parts == len(layout.parts)
    assert "SCRIPT ERROR" not in fresh_engine.output()
