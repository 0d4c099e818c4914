"""Starts engines for tests. Without one they skip; with ROADLANG_REQUIRE_GODOT=1 they fail."""

from __future__ import annotations

import os

import pytest

from roadlang_godot import engine as engines
from roadlang_godot.faults import EngineError


def started(**options: object) -> engines.Engine:
    try:
        return engines.start(**options)  # type: ignore[arg-type]
    except EngineError as error:
        absent = error.diagnostics[0].code in ("RL500", "RL508")
        if not absent or os.environ.get("ROADLANG_REQUIRE_GODOT") == "1":
            raise
        pytest.skip(f"no Godot engine: {error}")
