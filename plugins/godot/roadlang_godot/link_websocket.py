"""The same datagrams as binary messages of a WebSocket (RFC 6455): the bulk transport."""

from __future__ import annotations

import base64
import hashlib
import os
import select
import socket
import struct

_GUID = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
_BINARY = 0x82
_CLOSE, _PING = 0x8, 0x9
_CONNECT_SECONDS = 5.0


class WebSocketLink:
    """A client connection. Raises `OSError` where it cannot be made."""

    window = 1024

    def __init__(self, host: str, port: int) -> None:
        self._socket = socket.create_connection((host, port), timeout=_CONNECT_SECONDS)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._buffer = bytearray()
        self._upgrade(host, port)
        self._socket.settimeout(_CONNECT_SECONDS)

    def send(self, datagram: bytes) -> None:
        """Send one message. Raises `OSError` where the connection has gone."""
        self._send(_BINARY, datagram)

    def receive(self, timeout: float) -> list[bytes]:
        """All whole messages that have come, after waiting up to `timeout` seconds for data."""
        wait = max(0.0, timeout)
        while select.select([self._socket], [], [], wait)[0]:
            data = self._socket.recv(1 << 20)
            if not data:
                raise ConnectionResetError("the engine closed the connection")
            self._buffer += data
            wait = 0.0
        return self._messages()

    def close(self) -> None:
        """Close the connection."""
        self._socket.close()

    def _upgrade(self, host: str, port: int) -> None:
        key = base64.b64encode(os.urandom(16))
        request = (
            f"GET / HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\n"
            f"Connection: Upgrade\r\nSec-WebSocket-Key: {key.decode()}\r\n"
            "Sec-WebSocket-Version: 13\r\n\r\n"
        )
        self._socket.sendall(request.encode())
        while b"\r\n\r\n" not in self._buffer:
            data = self._socket.recv(4096)
            if not data or len(self._buffer) > 65536:
                raise ConnectionResetError("the engine does not speak WebSocket")
            self._buffer += data
        head, _, rest = bytes(self._buffer).partition(b"\r\n\r\n")
        accept = base64.b64encode(hashlib.sha1(key + _GUID, usedforsecurity=False).digest())
        if b" 101 " not in head.split(b"\r\n")[0] or accept not in head:
            raise ConnectionResetError("the engine does not speak WebSocket")
        self._buffer = bytearray(rest)

    def _send(self, opcode: int, payload: bytes) -> None:
        mask = os.urandom(4)
        if len(payload) < 126:
            head = struct.pack("!BB", opcode, 0x80 | len(payload))
        else:
            head = struct.pack("!BBH", opcode, 0x80 | 126, len(payload))
        self._socket.sendall(head + mask + _masked(payload, mask))

    def _messages(self) -> list[bytes]:
        out = []
        while (message := self._next()) is not None:
            opcode, payload = message
            if opcode == _CLOSE:
                raise ConnectionResetError("the engine closed the connection")
            if opcode == _PING:
                self._send(0x8A, payload)
            else:
                out.append(payload)
        return out

    def _next(self) -> tuple[int, bytes] | None:
        """The next whole frame: servers neither mask nor, for messages this short, fragment."""
        if len(self._buffer) < 2:
            return None
        opcode, length, at = self._buffer[0] & 0x0F, self._buffer[1] & 0x7F, 2
        extra = {126: 2, 127: 8}.get(length, 0)
        if extra:
            if len(self._buffer) < 2 + extra:
                return None
            length = int.from_bytes(self._buffer[2 : 2 + extra], "big")
            at = 2 + extra
        if len(self._buffer) < at + length:
            return None
        payload = bytes(self._buffer[at : at + length])
        del self._buffer[: at + length]
        return opcode, payload


def _masked(payload: bytes, mask: bytes) -> bytes:
    size = len(payload)
    stream = (mask * (size // 4 + 1))[:size]
    mixed = int.from_bytes(payload, "little") ^ int.from_bytes(stream, "little")
    return mixed.to_bytes(size, "little")
