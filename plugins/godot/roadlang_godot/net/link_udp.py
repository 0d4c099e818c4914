"""Datagrams over UDP."""

from __future__ import annotations

import contextlib
import select
import socket
import time


class UdpLink:
    """A socket that talks to one address. Raises `OSError` where that cannot be reached at all."""

    def __init__(self, host: str, port: int) -> None:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[
            0
        ]
        self._socket = socket.socket(family, kind, protocol)
        self._socket.connect(address)
        self._socket.setblocking(False)
        with contextlib.suppress(OSError):
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)

    def send(self, datagram: bytes) -> None:
        """Send, or lose: a full queue or an engine that is not there yet is no error here."""
        with contextlib.suppress(BlockingIOError, ConnectionError):
            self._socket.send(datagram)

    def receive(self, timeout: float) -> list[bytes]:
        """All that has come, after waiting up to `timeout` seconds for the first."""
        if not select.select([self._socket], [], [], max(0.0, timeout))[0]:
            return []
        out = []
        with contextlib.suppress(BlockingIOError, ConnectionError):
            while True:
                out.append(self._socket.recv(65536))
        if not out:  # nobody listens there, which the system says at once, to each datagram
            time.sleep(max(0.0, timeout))
        return out

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()
