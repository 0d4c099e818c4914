"""`--no-plugin NAME` leaves a plugin out of one command."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from roadlang.cli.main import run
from tests.plugins.installed import install
from tests.plugins.test_discovery import GOOD


def test_a_plugin_left_out_on_the_command_line(
    site: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROADLANG_NO_PLUGINS", raising=False)
    install(site, "good", GOOD.format(kind="zigzag"))
    scene = site / "scene.rl"
    scene.write_text(
        "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m)] } }\n"
        "road bent from main { perturb with zigzag { amplitude: 3m } }\n"
    )
    assert run(["check", str(scene)]) == 0
    assert run(["--no-plugin", "good", "check", str(scene)]) == 1
    assert "RL210" in "".join(capsys.readouterr())
    assert "ROADLANG_NO_PLUGINS" not in os.environ
