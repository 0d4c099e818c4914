"""Engines that the tests share."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from roadlang_godot.engines import engine as engines
from roadlang_godot.net import session as sessions
from roadlang_godot.net.session import Session
from tests.godot.godot_engines import started
from tests.godot.virtual_screen import virtual_screen


@pytest.fixture(autouse=True)
def patience(monkeypatch: pytest.MonkeyPatch) -> None:
    """A busy machine is no fault: engines are waited for much longer than by users."""
    monkeypatch.setattr(sessions, "PATIENCE", 300.0)
    monkeypatch.setattr(sessions, "SILENCE", 300.0)
    monkeypatch.setattr(sessions, "GOODBYE_SECONDS", 300.0)
    monkeypatch.setattr(engines, "ANSWER_TIMEOUT", 300.0)
    monkeypatch.setattr(engines, "START_SECONDS", 300.0)


@pytest.fixture(autouse=True)
def no_script_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    """A session with an engine that has printed a script error fails: its answer may never come."""
    ending = engines.Engine.ending
    sizes: dict[Path, int] = {}

    def sound_ending(engine: engines.Engine) -> str:
        size = engine.log.stat().st_size if engine.log.exists() else 0
        if sizes.get(engine.log, 0) != size:
            sizes[engine.log] = size
            assert "SCRIPT ERROR" not in engine.output(), engine.output()[-4000:]
        return ending(engine)

    monkeypatch.setattr(engines.Engine, "ending", sound_ending)


# An engine takes a part of a core also while it waits: these end when the tests of this folder, or
# those of a file, are done.
@pytest.fixture(scope="package")
def fast_engine() -> Iterator[engines.Engine]:
    """A headless engine that runs as fast as it can."""
    with started(fixed_fps=60, quit_idle=900.0) as engine:
        yield engine


@pytest.fixture(scope="module")
def drawing_engine() -> Iterator[engines.Engine]:
    """An engine that takes pictures."""
    with started(fixed_fps=60, draw=True, quit_idle=900.0) as engine:
        yield engine


@pytest.fixture
def fresh_engine() -> Iterator[engines.Engine]:
    """A headless engine in real time that no other test uses."""
    with started() as engine:
        yield engine


@pytest.fixture
def session(fast_engine: engines.Engine) -> Iterator[Session]:
    with fast_engine.connect("test") as session:
        yield session


@pytest.fixture(scope="session")
def screen() -> Iterator[str]:
    """A virtual screen for windows with a hand in them."""
    with virtual_screen() as name:
        yield name
