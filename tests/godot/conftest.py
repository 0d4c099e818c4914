"""Engines for the tests. Without one they skip; with ROADLANG_REQUIRE_GODOT=1 they fail."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from roadlang_standard.godot import engine as engines
from roadlang_standard.godot.faults import EngineError
from roadlang_standard.godot.session import Session


def _started(**options: object) -> engines.Engine:
    try:
        return engines.start(**options)  # type: ignore[arg-type]
    except EngineError as error:
        absent = error.diagnostics[0].code in ("RL500", "RL508")
        if not absent or os.environ.get("ROADLANG_REQUIRE_GODOT") == "1":
            raise
        pytest.skip(f"no Godot engine: {error}")


@pytest.fixture(scope="session")
def fast_engine() -> Iterator[engines.Engine]:
    """A headless engine that runs as fast as it can."""
    with _started(fixed_fps=60) as engine:
        yield engine


@pytest.fixture(scope="session")
def drawing_engine() -> Iterator[engines.Engine]:
    """An engine that takes pictures."""
    with _started(fixed_fps=60, draw=True) as engine:
        yield engine


@pytest.fixture
def fresh_engine() -> Iterator[engines.Engine]:
    """A headless engine in real time that no other test uses."""
    with _started() as engine:
        yield engine


@pytest.fixture
def session(fast_engine: engines.Engine) -> Iterator[Session]:
    with fast_engine.connect("test") as session:
        yield session
