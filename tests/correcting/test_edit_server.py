"""The server of the page, without a browser: what it is sent, and who goes away."""

from __future__ import annotations

import socket
import struct
from collections.abc import Iterator
from pathlib import Path
from threading import Thread

import cv2
import numpy as np
import pytest

from roadlang.correcting.picture_roads import PictureRoads
from roadlang.correcting.server import CorrectionServer


@pytest.fixture
def server(tmp_path: Path) -> Iterator[CorrectionServer]:
    cv2.imwrite(str(tmp_path / "plan.png"), np.full((60, 80, 3), 255, np.uint8))
    scene = tmp_path / "a.rl"
    scene.write_text(
        'image photo from "plan.png" { scale: 0.5m/px }\n'
        "network town from photo { extract with contour }\n"
    )
    with CorrectionServer(PictureRoads.of(scene, tmp_path / "plan.png"), "s") as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


def asked(server: CorrectionServer, request: str, body: bytes = b"") -> bytes:
    """The first line of the answer to `GET page.html` and the like."""
    verb, name = request.split()
    head = f"{verb} /s/{name} HTTP/1.0\r\nHost: 127.0.0.1:{server.server_port}\r\n"
    with socket.create_connection(("127.0.0.1", server.server_port), timeout=30) as link:
        link.sendall(f"{head}Content-Length: {len(body)}\r\n\r\n".encode() + body)
        return link.makefile("rb").readline()


def test_a_browser_that_goes_away_is_no_fault(
    server: CorrectionServer, capfd: pytest.CaptureFixture[str]
) -> None:
    try:
        raise ConnectionResetError
    except ConnectionResetError:
        server.handle_error(None, None)
    for _ in range(5):
        with socket.create_connection(("127.0.0.1", server.server_port), timeout=30) as link:
            # Closed with a reset, as a browser does that loads the page anew.
            link.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            link.sendall(b"GET /s/picture HTTP/1.0\r\n\r\n")
    assert b"200" in asked(server, "GET page.html")
    assert server.fault is None
    assert "Traceback" not in capfd.readouterr().err


def test_what_is_nested_too_deep_is_a_bad_request(server: CorrectionServer) -> None:
    assert b"400" in asked(server, "POST roads", b"[" * 100_000)
    assert server.fault is None


def test_any_other_error_is_kept_for_the_command(server: CorrectionServer) -> None:
    try:
        raise ZeroDivisionError
    except ZeroDivisionError:
        server.handle_error(None, None)
    assert isinstance(server.fault, ZeroDivisionError)
