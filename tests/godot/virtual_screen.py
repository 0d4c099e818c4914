"""A screen that nobody sees, and a hand at its mouse and keyboard."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

import pytest

from tests.godot.godot_engines import until


@contextmanager
def virtual_screen() -> Iterator[str]:
    """Its name, for DISPLAY. Skips where there is none."""
    if not (shutil.which("Xvfb") and shutil.which("xdotool")):
        pytest.skip("needs Xvfb and xdotool")
    read, write = os.pipe()
    server = subprocess.Popen(
        # It would begin anew whenever the last program leaves, and refuse others meanwhile.
        ["Xvfb", "-noreset", "-displayfd", str(write), "-screen", "0", "1280x720x24"],
        pass_fds=[write],
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    try:
        with os.fdopen(read) as number:
            yield f":{number.readline().strip()}"
    finally:
        server.terminate()
        server.wait()


class Hand:
    """Moves the pointer and presses keys in the window of the engine on a screen."""

    def __init__(self, screen: str) -> None:
        self._environment = {**os.environ, "DISPLAY": screen}
        self._window = ""
        until(self._found)
        self.do("windowfocus", self._window)

    def _found(self) -> bool:
        search = ["xdotool", "search", "--onlyvisible", "--name", "roadlang"]
        found = subprocess.run(
            search, env=self._environment, capture_output=True, text=True, check=False
        )
        self._window = found.stdout.strip().splitlines()[-1] if found.stdout.strip() else ""
        return bool(self._window)

    def do(self, *words: str) -> None:
        subprocess.run(["xdotool", *words], env=self._environment, check=True)

    def move(self, x: float, y: float) -> None:
        self.do("mousemove", "--window", self._window, str(round(x)), str(round(y)))

    def sweep(self, places: Iterable[tuple[float, float]], pause: float) -> None:
        """Move through places, so many seconds apart, in one command."""
        words: list[str] = []
        for x, y in places:
            words += ["mousemove", "--window", self._window, str(round(x)), str(round(y))]
            words += ["sleep", str(pause)]
        self.do(*words)
