"""The WebSocket link, against a server that is not Godot's."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import Server, ServerConnection, serve

from roadlang_godot.engines import engine
from roadlang_godot.faults import EngineError
from roadlang_godot.net.link_websocket import WebSocketLink


@contextmanager
def server(handler: Callable[[ServerConnection], None]) -> Iterator[int]:
    """A server that gives every connection to `handler`; its port."""
    running: Server = serve(handler, "127.0.0.1", 0)
    thread = threading.Thread(target=running.serve_forever)
    thread.start()
    try:
        yield running.socket.getsockname()[1]
    finally:
        running.shutdown()
        thread.join()


def silence(connection: ServerConnection) -> None:
    """Wait until the client leaves."""
    with suppress(ConnectionClosed):
        connection.recv()


def received(link: WebSocketLink, count: int) -> list[bytes]:
    messages: list[bytes] = []
    while len(messages) < count:
        messages += link.receive(timeout=300.0)
    return messages


def test_messages_come_back_whole_and_in_order() -> None:
    sent = [bytes([number]) * size for number, size in enumerate((0, 1, 125, 126, 1200, 8192))]

    def echo(connection: ServerConnection) -> None:
        for message in connection:
            connection.send(message)

    with server(echo) as port:
        link = WebSocketLink("127.0.0.1", port)
        for message in sent:
            link.send(message)
        assert received(link, len(sent)) == sent
        link.close()


def test_a_message_in_fragments_is_one_message() -> None:
    def fragments(connection: ServerConnection) -> None:
        connection.send([b"one ", b"mess", b"age"])
        silence(connection)

    with server(fragments) as port:
        link = WebSocketLink("127.0.0.1", port)
        assert received(link, 1) == [b"one message"]
        link.close()


def test_nothing_to_receive_is_an_empty_list() -> None:
    with server(silence) as port:
        link = WebSocketLink("127.0.0.1", port)
        assert link.receive(timeout=0.0) == []
        link.close()


def test_a_connection_that_the_other_side_closes_is_an_os_error() -> None:
    with server(lambda connection: None) as port:
        link = WebSocketLink("127.0.0.1", port)
        with pytest.raises(OSError, match="closed the connection"):
            received(link, 1)
        with pytest.raises(OSError, match="closed the connection"):
            link.send(b"too late")


def test_without_the_package_the_diagnostic_names_the_extra(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delitem(sys.modules, "roadlang_godot.net.link_websocket", raising=False)
    monkeypatch.setitem(sys.modules, "websockets.sync.client", None)
    with pytest.raises(EngineError, match="RL516") as caught:
        engine.connect("127.0.0.1", 9, "websocket")
    assert "roadlang[websocket]" in caught.value.diagnostics[0].help[0]


@pytest.mark.parametrize("timeout", [0.0, -1.0])
def test_without_time_to_wait_what_has_come_is_received(timeout: float) -> None:
    with server(silence) as port:
        link = WebSocketLink("127.0.0.1", port)
        assert link.receive(timeout) == []
        link.close()


def test_it_waits_for_a_message_that_is_still_to_come() -> None:
    def answer(connection: ServerConnection) -> None:
        for message in connection:
            time.sleep(0.1)
            connection.send(message)

    with server(answer) as port:
        link = WebSocketLink("127.0.0.1", port)
        for message in (b"one", b"two"):
            link.send(message)
            assert link.receive(timeout=300.0) == [message]
        link.close()
