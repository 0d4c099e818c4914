"""Starts engines for tests. Without one they skip; with ROADLANG_REQUIRE_GODOT=1 they fail."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from functools import cache

import pytest

from roadlang_godot.engines import engine as engines
from roadlang_godot.faults import EngineError


def started(**options: object) -> engines.Engine:
    try:
        return engines.start(**options)  # type: ignore[arg-type]
    except EngineError as error:
        absent = error.diagnostics[0].code in ("RL500", "RL508")
        if not absent or os.environ.get("ROADLANG_REQUIRE_GODOT") == "1":
            raise
        pytest.skip(f"no Godot engine: {error}")


@cache
def require_engine() -> None:
    """For tests whose engines something else starts. One is started once in each process."""
    started().stop()


def until(holds: Callable[[], object]) -> None:
    """Wait for something that happens in an engine's own time. Only a hang fails."""
    limit = time.monotonic() + 300.0
    while not holds():
        assert time.monotonic() < limit, "it did not happen within five minutes"
