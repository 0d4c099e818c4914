"""A session with an engine: handshake, reliable messages, and the proof of what was built."""

from __future__ import annotations

import json
import os
import struct
import time
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from roadlang.api import Code

from ..faults import fault, not_built
from . import protocol
from .link import DatagramLink
from .messages import Proof, as_json, refusal, text_of
from .protocol import Message
from .reliable_channel import Channel
from .scene_part import RECORD_BYTES, Key, ScenePart, part_digest, record_key, removal, unlike

PATIENCE = 5.0
"""Seconds for which an engine that someone else started is waited for."""
SILENCE = 30.0
"""Seconds for which one that has answered may be silent: drawing in software takes long."""
_HELLO_EVERY, _PING_EVERY = 0.1, 1.0
GOODBYE_SECONDS, _GOODBYE_EVERY = 1.0, 0.05
"""For how long, and how often, goodbye is said to an engine that does not answer it."""

_BEGIN, _PART = struct.Struct("<HH"), struct.Struct("<IHH")
_COMMIT = struct.Struct("<HHI")
_BUILT = struct.Struct("<HHIII16s")
_PROBE = struct.Struct("<IHHff")


class Session:
    """A connection to one engine. Use as a context manager; every wait ends or raises.

    `patience` is in seconds, by default `PATIENCE` for the first answer and `SILENCE` from then on.
    Where the engine's process has ended, which `ending` says in words, no wait goes on.
    """

    def __init__(
        self,
        link: DatagramLink,
        *,
        patience: float | None = None,
        name: str = "",
        ending: Callable[[], str] = str,
    ) -> None:
        self.patience = PATIENCE if patience is None else patience
        self._silence = SILENCE if patience is None else patience
        self._ending = ending
        self._link = link
        self._channel = Channel(getattr(link, "window", protocol.WINDOW))
        self._inbox: deque[tuple[int, bytes]] = deque()
        self._built: dict[int, dict[Key, tuple[int, ScenePart]]] = {}
        self._revision = 0
        self._request = 0
        self._last_heard = self._last_sent = self._last_pump = time.monotonic()
        self._session = 0
        self.on_state: Callable[[bytes], None] | None = None
        self.process: int | None = None
        """of an engine that only computes, and takes turns with this one"""
        self.welcome = self._greet(name)

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Say goodbye until the engine says it too, or does not seem to hear it; leave."""
        deadline = time.monotonic() + GOODBYE_SECONDS
        try:
            while time.monotonic() < deadline and not self._ending():
                self.send_once(Message.BYE, b"")
                if self._hears_goodbye(time.monotonic() + _GOODBYE_EVERY):
                    break
        except OSError:
            pass
        finally:
            self._link.close()

    def _hears_goodbye(self, until: float) -> bool:
        while (left := until - time.monotonic()) > 0.0:  # the engine may have more to say first
            frames = map(protocol.unpack, self._link.receive(left))
            if any(frame is not None and frame.type == Message.BYE for frame in frames):
                return True
        return False

    # -- scenes ---------------------------------------------------------------------------------

    def begin(self, settings: Mapping[str, Any], world: int = 0, *, clear: bool = False) -> None:
        """Start an empty world; with `clear` all others go. `settings`: name, extent, ticks."""
        if clear:
            self._built.clear()
        self._built[world] = {}
        payload = _BEGIN.pack(world, int(clear)) + as_json(settings)
        self.send(Message.BEGIN, payload, "the scene's beginning")
        self.flush()

    def update(self, parts: Iterable[ScenePart], world: int = 0, *, waits: bool = True) -> int:
        """Send what differs from what this world holds. Returns how many messages that took.

        What was sent before has arrived by then. So has this, unless it does not wait for that.
        """
        self.flush()
        built = self._built.setdefault(world, {})
        wanted = {part.key: part for part in parts}
        self._revision += 1
        count = 0
        for key, part in wanted.items():
            if key not in built or built[key][1].body != part.body:
                built[key] = (self._revision, part)
                self.send(part.kind, part.message(world, self._revision), part.label)
                count += 1
        for key in [key for key in built if key not in wanted]:
            label = built.pop(key)[1].label
            self.send(Message.REMOVE, removal(world, key, self._revision), f"end of {label}")
            count += 1
        self.flush() if waits else self.pump(0.0)
        return count

    def prove(self, world: int = 0) -> Proof:
        """Compare what the engine's scene tree holds with what was sent.

        Raises `EngineError` (RL504) that names what is missing or different.
        """
        request = self._next_request()
        self.send(Message.COMMIT, _COMMIT.pack(world, 0, request), "the proof")
        while True:
            _, _, answered, count, builds, digest = _BUILT.unpack(self.expect(Message.BUILT))
            if answered == request:
                break
        built = self._built.get(world, {})
        wanted = {key: part.record(revision) for key, (revision, part) in built.items()}
        if digest != part_digest(wanted.values()):
            self._name_missing(world, wanted)
        return Proof(count, builds, digest)

    def records(self, world: int = 0) -> dict[Key, bytes]:
        """The proof of each thing that the engine holds."""
        request = self._next_request()
        self.send(Message.LIST, _COMMIT.pack(world, 0, request), "the list of things")
        payload = self._parts(Message.REPORT, request)
        step = RECORD_BYTES
        found = [payload[at : at + step] for at in range(0, len(payload), step)]
        return {record_key(record): record for record in found}

    def probe(self, x: float, y: float, world: int = 0) -> float | None:
        """The height of the ground at a place of the engine's own coordinates; None: nothing."""
        request = self._next_request()
        self.send(Message.PROBE, _PROBE.pack(request, world, 0, x, y), "a probe")
        while True:
            payload = self.expect(Message.PROBED)
            answered, hit, height = struct.unpack("<IBxxxf", payload)
            if answered == request:
                return float(height) if hit else None

    def fetch(self, type: Message, wish: Mapping[str, Any], answer: Message) -> bytes:
        """The bytes that answer a wish. Raises `EngineError` RL508 for pictures with no screen."""
        if type != Message.EXPORT and not self.welcome.get("pictures"):
            raise fault(Code.RENDERING_UNAVAILABLE)
        request = self._next_request()
        self.send_json(type, {**wish, "id": request}, f"the message {type.name}")
        return self._parts(answer, request)

    # -- messages -------------------------------------------------------------------------------

    def send(self, type: Message, payload: bytes, label: str = "") -> None:
        """Queue a message that will arrive exactly once."""
        self._channel.offer(type, payload, label)

    def send_json(self, type: Message, value: Mapping[str, Any], label: str = "") -> None:
        """Queue a JSON object."""
        self.send(type, as_json(value), label)

    def send_once(self, type: Message, payload: bytes) -> None:
        """Send a message that may be lost."""
        self._last_sent = time.monotonic()
        self._link.send(protocol.pack(type, self._session, 0, payload))

    def flush(self) -> None:
        """Wait until all that was queued has arrived.

        Raises `EngineError` (RL504, RL505, RL507).
        """
        while not self._channel.idle:
            self.pump(0.02)

    def expect(self, type: Message) -> bytes:
        """Wait for a message of this type, leaving others in the inbox."""
        while (payload := self.take(type)) is None:
            self.pump(0.02)
        return payload

    def take(self, type: Message) -> bytes | None:
        """The oldest message of this type that has come, or None."""
        for index, (kind, payload) in enumerate(self._inbox):
            if kind == type:
                del self._inbox[index]
                return payload
        return None

    def pump(self, timeout: float) -> None:
        """Send what is pending and take what has arrived, waiting for it up to `timeout`
        seconds."""
        now = time.monotonic()
        if now - self._last_pump > _PING_EVERY:
            # Nobody listened for a while: that the engine was not heard then is no sign.
            self._last_heard = now
        self._last_pump = now
        for type, seq, payload in self._channel.to_send(now):
            self._last_sent = now
            self._link.send(protocol.pack(type, self._session, seq, payload))
        if now - self._last_sent > _PING_EVERY:
            self.send_once(Message.PING, b"")
        wait = min(timeout, max(0.0, self._channel.next_due() - now))
        for datagram in (heard := self._receive(wait)):
            self._take(datagram)
        if ack := self._channel.take_ack():
            self._link.send(protocol.pack(Message.ACK, self._session, 0, ack))
        self._check_alive(bool(heard))

    def _receive(self, wait: float) -> list[bytes]:
        try:
            return self._link.receive(wait)
        except OSError as error:
            raise fault(Code.GODOT_DISCONNECTED, reason=str(error)) from error

    def _take(self, datagram: bytes) -> None:
        frame = protocol.unpack(datagram)
        if frame is None or frame.session != self._session:
            return
        self._last_heard = time.monotonic()
        if frame.type == Message.ACK:
            self._channel.acknowledged(frame.payload)
        elif frame.type == Message.STATE and self.on_state is not None:
            self.on_state(frame.payload)
        elif frame.type == Message.BYE:
            raise fault(Code.GODOT_DISCONNECTED, reason="it said goodbye")
        elif frame.seq and self._channel.accept(frame.seq):
            if frame.type == Message.ERROR:
                raise fault(Code.GODOT_ERROR, reason=text_of(frame.payload))
            self._inbox.append((frame.type, frame.payload))

    def _check_alive(self, spoke: bool) -> None:
        if not spoke and (ending := self._ending()):
            raise fault(Code.GODOT_DISCONNECTED, reason=ending)
        now = time.monotonic()
        if late := self._channel.overdue(now, self._silence):
            raise not_built(late)
        if now - self._last_heard > self._silence + 2 * _PING_EVERY:
            raise fault(
                Code.GODOT_DISCONNECTED, reason=f"nothing heard for {now - self._last_heard:.0f} s"
            )

    def _greet(self, name: str) -> dict[str, Any]:
        nonce = int.from_bytes(os.urandom(4), "little")
        version = protocol.VERSION
        hello = as_json({"protocol": [version, version], "nonce": nonce, "scene": name})
        deadline = time.monotonic() + self.patience
        while time.monotonic() < deadline and not self._ending():
            self._link.send(protocol.pack(Message.HELLO, 0, 0, hello))
            for datagram in self._receive(_HELLO_EVERY):
                frame = protocol.unpack(datagram)
                if frame is None:
                    continue
                if frame.type == Message.ERROR and frame.session == 0:
                    raise refusal(frame.payload)
                if frame.type == Message.WELCOME:
                    self._session = frame.session
                    self._last_heard = time.monotonic()
                    welcome: dict[str, Any] = json.loads(frame.payload)
                    return welcome
        if ending := self._ending():
            raise fault(Code.GODOT_DISCONNECTED, reason=ending)
        raise fault(Code.GODOT_NOT_ANSWERING, seconds=f"{self.patience:.0f}")

    def _name_missing(self, world: int, wanted: Mapping[Key, bytes]) -> None:
        labels = {key: part.label for key, (_, part) in self._built[world].items()}
        raise not_built(unlike(wanted, self.records(world), labels))

    def _parts(self, type: Message, request: int) -> bytes:
        parts: dict[int, bytes] = {}
        total = None
        while total is None or len(parts) < total:
            payload = self.expect(type)
            answered, part, count = _PART.unpack_from(payload)
            if answered == request:
                parts[part] = payload[_PART.size :]
                total = count
        return b"".join(parts[part] for part in sorted(parts))

    def _next_request(self) -> int:
        self._request += 1
        return self._request
