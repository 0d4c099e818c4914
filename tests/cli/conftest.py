"""A folder with a scene, for tests of commands."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.command_lines import SCENE


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "scene.rl").write_text(SCENE)
    return tmp_path
