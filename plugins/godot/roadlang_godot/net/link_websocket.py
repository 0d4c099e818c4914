"""The same datagrams as binary messages of a WebSocket: the bulk transport.

Needs the package `websockets`, which the extra `roadlang[websocket]` brings.
"""

from __future__ import annotations

import contextlib

from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.sync.client import connect

_CONNECT_SECONDS = 20.0


class WebSocketLink:
    """A client connection. Raises `OSError` where it cannot be made."""

    window = 1024

    def __init__(self, host: str, port: int) -> None:
        address = f"[{host}]" if ":" in host else host
        connecting = connect(
            f"ws://{address}:{port}/",
            compression=None,
            proxy=None,
            ping_interval=None,  # the protocol has its own sign of life
            max_queue=None,  # the window limits what is under way
            open_timeout=_CONNECT_SECONDS,
            close_timeout=_CONNECT_SECONDS,
        )
        self._stack = contextlib.ExitStack()
        try:
            self._connection = self._stack.enter_context(connecting)
        except InvalidHandshake as error:
            raise ConnectionResetError("the engine does not speak WebSocket") from error

    def send(self, datagram: bytes) -> None:
        """Send one message. Raises `OSError` where the connection has gone."""
        try:
            self._connection.send(datagram)
        except ConnectionClosed as error:
            raise ConnectionResetError("the engine closed the connection") from error

    def receive(self, timeout: float) -> list[bytes]:
        """All messages that have come, after waiting up to `timeout` seconds for the first."""
        messages: list[bytes] = []
        wait = max(0.0, timeout)
        try:
            with contextlib.suppress(TimeoutError):
                while True:
                    message = self._connection.recv(timeout=wait)
                    if isinstance(message, bytes):  # a text message is none of ours
                        messages.append(message)
                    wait = 0.0
        except ConnectionClosed as error:
            if not messages:
                raise ConnectionResetError("the engine closed the connection") from error
        return messages

    def close(self) -> None:
        """Close the connection."""
        self._stack.close()
