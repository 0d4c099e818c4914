"""A headless Chromium for tests, spoken to over its DevTools protocol.

Without one tests skip; with ROADLANG_REQUIRE_BROWSER=1 they fail.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from typing import Any

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
_FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--disable-extensions",
    "--no-first-run", "--disable-background-networking", "--remote-debugging-port=0",
)  # fmt: skip
_WAIT = 300


def find_browser() -> str:
    """The path of a Chromium; skips the test where there is none."""
    for name in NAMES:
        found = shutil.which(name)
        if found:
            return found
    reason = f"needs a browser: none of {', '.join(NAMES)} is installed"
    if os.environ.get("ROADLANG_REQUIRE_BROWSER") == "1":
        pytest.fail(reason)
    pytest.skip(reason)


class Page:
    """A page that is open. `faults` are exceptions and errors on its console, `requests` the
    addresses that it asked for, `questions` the kinds of dialogs it showed, which are accepted."""

    def __init__(self, socket: Any) -> None:
        self._socket = socket
        self._numbers = count(1)
        self.faults: list[str] = []
        self.requests: list[str] = []
        self.questions: list[str] = []
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.send(f"{domain}.enable")

    def send(self, method: str, **parameters: Any) -> Any:
        """The answer to a command of the protocol."""
        number = self._post(method, **parameters)
        while True:
            message = self._receive()
            if message.get("id") == number:
                assert "error" not in message, message
                return message["result"]

    def _post(self, method: str, **parameters: Any) -> int:
        """The number of a command, whose answer is still to come."""
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        return number

    def open(self, address: str) -> None:
        """Load a page and wait until it has loaded."""
        self.send("Page.navigate", url=address)
        while self._receive().get("method") != "Page.loadEventFired":
            pass

    def run(self, script: str) -> Any:
        """The value of an expression in the page; a promise is waited for."""
        found = self.send(
            "Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True
        )
        assert "exceptionDetails" not in found, found
        return found["result"].get("value")

    def resize(self, wide: int, tall: int) -> None:
        """Give the page another size."""
        self.send(
            "Emulation.setDeviceMetricsOverride",
            width=wide, height=tall, deviceScaleFactor=1, mobile=False,
        )  # fmt: skip

    def _receive(self) -> dict[str, Any]:
        message: dict[str, Any] = json.loads(self._socket.recv(timeout=_WAIT))
        parameters = message.get("params", {})
        match message.get("method"):
            case "Page.javascriptDialogOpening":
                self.questions.append(parameters["type"])
                self._post("Page.handleJavaScriptDialog", accept=True)
            case "Network.requestWillBeSent":
                self.requests.append(parameters["request"]["url"])
            case "Runtime.exceptionThrown":
                self.faults.append(str(parameters["exceptionDetails"]))
            case "Runtime.consoleAPICalled" if parameters["type"] in ("error", "warning"):
                self.faults.append(str(parameters["args"]))
            case "Log.entryAdded" if parameters["entry"]["level"] in ("error", "warning"):
                self.faults.append(str(parameters["entry"]))
        return message


@contextmanager
def browser() -> Iterator[Page]:
    """A fresh browser with one page."""
    connect = pytest.importorskip("websockets.sync.client").connect
    command = find_browser()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        process = subprocess.Popen(
            [command, *_FLAGS, f"--user-data-dir={profile}", "about:blank"],
            stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
        )  # fmt: skip
        try:
            with connect(_page_address(process), max_size=None) as socket:
                yield Page(socket)
        finally:
            process.terminate()
            process.wait(_WAIT)


def _page_address(process: subprocess.Popen[str]) -> str:
    from urllib.request import urlopen

    assert process.stderr is not None
    for line in process.stderr:
        found = re.search(r"DevTools listening on ws://([^/]+)/", line)
        if found:
            with urlopen(f"http://{found[1]}/json/list", timeout=_WAIT) as answer:
                pages = json.load(answer)
            return str(next(p for p in pages if p["type"] == "page")["webSocketDebuggerUrl"])
    raise AssertionError("the browser has ended")


def address_of(path: Path) -> str:
    """The address of a file."""
    return path.absolute().as_uri()
