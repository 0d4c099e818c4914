"""The page on which roads are corrected: an HTTP server on this machine alone."""

from __future__ import annotations

import json
import sys
from functools import cached_property
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Event
from typing import Any

import cv2

from ..diagnostics import DiagnosticError
from ..images.mapped_pixels import mapped
from ..syntax.correction_edits import WrittenCorrections
from .picture_roads import PictureRoads

_PAGE = Path(__file__).parent / "page"
_TYPES = {".html": "text/html", ".css": "text/css", ".js": "text/javascript"}
_MOST_BYTES = 4_000_000
_POLICY = "default-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'"


class CorrectionServer(ThreadingHTTPServer):
    """Serves one page, whose address holds a `secret`, until the page sets `done`.

    It listens on the loopback interface alone, and answers only requests that name it as their
    host and begin with the secret: no other page in the browser can read or change anything.
    """

    daemon_threads = True

    def __init__(self, roads: PictureRoads, secret: str) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.roads = roads
        self.secret = secret
        self.done = Event()
        self.fault: BaseException | None = None
        """what failed here while a request was answered: a bug, for the command to raise"""

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that goes away before its answer, as on a reload, is no fault."""
        error = sys.exc_info()[1]
        if not isinstance(error, ConnectionError):
            self.fault = self.fault or error

    @property
    def address(self) -> str:
        """Where the page is."""
        return f"http://127.0.0.1:{self.server_port}/{self.secret}/"

    @cached_property
    def picture(self) -> bytes:
        """The picture as a PNG file, in the pixels of its own file."""
        picture = self.roads.picture
        assert picture.pixels is not None
        pixels = mapped(picture.pixels, picture.file)
        return bytes(cv2.imencode(".png", pixels, [cv2.IMWRITE_PNG_COMPRESSION, 3])[1].tobytes())

    def start(self) -> dict[str, Any]:
        """What is sent to the page when it opens."""
        corrections = self.roads.written()
        width, height = self.roads.picture.file_size
        return {
            "width": width,
            "height": height,
            "file": self.roads.path.name,
            "network": self.roads.name,
            "found": self.roads.found_roads(),
            "remarks": list(self.roads.remarks),
            "corrections": {
                "drawn": corrections.drawn,
                "dismissed": corrections.dismissed,
                "confirmed": corrections.confirmed,
            },
            **self.roads.roads(corrections),
        }

    def saved(self, corrections: WrittenCorrections) -> dict[str, Any]:
        """Write the corrections into the scene file, and say whether that was possible."""
        try:
            self.roads.save(corrections)
        except DiagnosticError as error:
            return {"error": error.diagnostics[0].message}
        return {"saved": True}


class _Handler(BaseHTTPRequestHandler):
    server: CorrectionServer

    def do_GET(self) -> None:
        name = self._name()
        if name is None:
            return
        if name == "start":
            self._answer(self.server.start())
        elif name == "picture":
            self._send(self.server.picture, "image/png")
        else:
            file = _PAGE / (name or "page.html")
            if file.parent != _PAGE or file.suffix not in _TYPES or not file.is_file():
                self.send_error(HTTPStatus.NOT_FOUND)
                return
            self._send(file.read_bytes(), f"{_TYPES[file.suffix]}; charset=utf-8")

    def do_POST(self) -> None:
        name = self._name()
        if name is None:
            return
        corrections = self._corrections()
        if corrections is None:
            self.send_error(HTTPStatus.BAD_REQUEST)
        elif name == "roads":
            self._answer(self.server.roads.roads(corrections))
        elif name == "save":
            self._answer(self.server.saved(corrections))
        elif name == "done":
            self._answer({})
            self.server.done.set()
        else:
            self.send_error(HTTPStatus.NOT_FOUND)

    def _name(self) -> str | None:
        """What is asked for; None, answered, for requests of others."""
        host = self.headers.get("Host", "")
        start = f"/{self.server.secret}/"
        if host != f"127.0.0.1:{self.server.server_port}" or not self.path.startswith(start):
            self.send_error(HTTPStatus.FORBIDDEN)
            return None
        return self.path[len(start) :]

    def _corrections(self) -> WrittenCorrections | None:
        try:
            size = int(self.headers.get("Content-Length", ""))
            if not 0 <= size <= _MOST_BYTES:
                return None
            sent = json.loads(self.rfile.read(size))
            lines = [tuple(_line(line) for line in sent[key]) for key in ("drawn", "dismissed")]
            if any(len(line) < 2 for line in lines[0]) or not all(lines[1]):
                return None
            return WrittenCorrections(lines[0], lines[1], _line(sent["confirmed"]))
        except (ValueError, TypeError, KeyError, OverflowError, RecursionError):
            return None

    def _answer(self, content: dict[str, Any]) -> None:
        self._send(json.dumps(content).encode("utf-8"), "application/json")

    def _send(self, content: bytes, kind: str) -> None:
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Content-Security-Policy", _POLICY)
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *_: object) -> None:
        """Nothing: the terminal belongs to the command."""


def _line(points: Any) -> tuple[tuple[float, float], ...]:
    """Points of a request. Raises ValueError for what is none."""
    found = tuple((float(x), float(y)) for x, y in points)
    if not all(abs(value) < 1e6 for point in found for value in point):
        raise ValueError
    return found
