"""Drags by a real mouse in a window on a virtual screen: moves shown each second, and the CPU time
of one with the drawing of frames. Needs Xvfb and xdotool."""

from __future__ import annotations

import os
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import roadlang
from benchmarks.godot.engine_time import engine_seconds
from roadlang.commands import handles_of
from roadlang_godot.commands.watch import Watcher
from roadlang_godot.editing.live import HandEdit, LiveScene
from roadlang_godot.engines import engine
from roadlang_godot.net.protocol import Message
from roadlang_godot.net.session import Session
from tests.godot.test_hands import METERS, PICTURE, SEGMENTS, THINGS, TOWN
from tests.godot.virtual_screen import Hand, virtual_screen

WIDTH, HEIGHT = 640, 360
CENTER = (60.0, 20.0)
PLACES, PAUSE = 200, 0.02
LOOKS = 40
Drag = tuple[str, str, float]
"""A text, the name of what is dragged, and the x of its handle."""
DRAGS: dict[str, Drag] = {
    "photo road": (PICTURE + THINGS, "main", 70.0),
    "segment road": (SEGMENTS + THINGS, "main", 60.0),
    "network junction": (TOWN, "main", 66.0),
    "agent": (SEGMENTS + THINGS, "ego", 5.0),
    "object": (SEGMENTS + THINGS, "kiosk", 40.0),
}


class CountingWatcher(Watcher):
    """Counts the moves that it shows."""

    shown = 0

    def take(self, live: LiveScene, edit: HandEdit) -> None:
        """Count, and show."""
        self.shown += 1
        super().take(live, edit)


def window_drags() -> None:
    """One drag of each kind, after one that warms up."""
    with virtual_screen() as screen, pytest.MonkeyPatch.context() as patch:
        patch.setenv("DISPLAY", screen)
        size = ["--resolution", f"{WIDTH}x{HEIGHT}"]
        with engine.start(window=True, extra=size, quit_idle=900.0) as running:
            for kind in ("segment road", *DRAGS):
                with running.connect() as session:
                    rate, client, built = _drag(running, session, Hand(screen), DRAGS[kind])
                load = os.getloadavg()[0]
                print(
                    f"drag of a {kind} in a window: {rate:.1f} Hz; client {client:.0f} ms, engine "
                    f"with drawing {built:.0f} ms of CPU a move; load {load:.0f}"
                )


def _drag(
    running: engine.Engine, session: Session, hand: Hand, drag: Drag
) -> tuple[float, float, float]:
    """Moves shown each second, and CPU ms of the client and of the engine for each."""
    text, name, near = drag
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.rl"
        file.write_text(text, encoding="utf-8")
        loaded = roadlang.load(file)
        watcher = CountingWatcher(loaded, 0, "mesh", save=False)
        live = watcher.start(session, loaded.sample(1, seed=0)[0].record)
        frame = live.layout.frame
        x, y = CENTER[0] - frame.x, CENTER[1] - frame.y
        session.send_json(Message.VIEW, {"camera": "top", "x": x, "y": y, "size": METERS})
        known = [one for one in handles_of(text, live.scene) if one.name == name]
        handle = min(known, key=lambda one: abs(one.x - near))
        scale = HEIGHT / METERS
        at = (
            WIDTH / 2 + scale * (handle.x - CENTER[0]),
            HEIGHT / 2 - scale * (handle.y - CENTER[1]),
        )
        for _ in range(LOOKS):  # until it is drawn
            watcher.listen(live)
        hand.move(*at)
        hand.do("mousedown", "1")
        places = [(at[0] + 0.9 * (i % 50), at[1] - 0.3 * (i % 50)) for i in range(1, PLACES)]
        with ThreadPoolExecutor(1) as pool:
            began = time.monotonic(), time.process_time(), engine_seconds(running)
            sweep = pool.submit(hand.sweep, places, PAUSE)
            while not sweep.done():
                watcher.listen(live)
                watcher.look(live)
            ended = time.monotonic(), time.process_time(), engine_seconds(running)
        hand.do("mouseup", "1")
        watcher.settle(live)
    took, client, built = (after - before for before, after in zip(began, ended, strict=True))
    count = max(1, watcher.shown)
    return count / took, 1000 * client / count, 1000 * built / count
