"""A folder into which a test installs plugins."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

SHIPPED = ("roadlang_standard", "roadlang_godot")


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder of installed plugins; none that an earlier test imported is still there."""
    monkeypatch.syspath_prepend(str(tmp_path))
    _forget_plugins()
    yield tmp_path
    _forget_plugins()


def _forget_plugins() -> None:
    for name in list(sys.modules):
        if name.startswith("roadlang_") and name.split(".")[0] not in SHIPPED:
            del sys.modules[name]
