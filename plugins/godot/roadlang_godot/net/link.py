"""What carries datagrams between a session and an engine."""

from __future__ import annotations

from typing import Protocol


class DatagramLink(Protocol):
    """A way to send and receive datagrams."""

    def send(self, datagram: bytes) -> None:
        """Send one datagram. May lose it; raises `OSError` where the engine has gone."""

    def receive(self, timeout: float) -> list[bytes]:
        """What has come, after waiting up to `timeout` seconds for the first datagram."""

    def close(self) -> None:
        """Release the socket."""
