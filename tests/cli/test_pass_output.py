"""What passes make of a scene is shown pass by pass, and showing it changes nothing."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import roadlang
from roadlang.cli.pass_output import PassPrinter

BENDS = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 10m), (160m, -10m)] }, width: 7m }
road bent from main {
  perturb with sine { amplitude: 2m..6m, wavelength: 80m }
  perturb with bump { at: 60m, height: 1m..2m, length: 30m }
}
require near: always (deviation(bent, main) < 6m)
"""


def printed(capsys: pytest.CaptureFixture[str], name: str, n: int = 1) -> list[str]:
    loaded = roadlang.loads(BENDS)
    loaded.sample(n, after_pass=PassPrinter(loaded.scenario, name))
    return capsys.readouterr().err.splitlines()


def test_passes_are_shown_in_their_order(capsys: pytest.CaptureFixture[str]) -> None:
    lines = printed(capsys, "all", n=2)
    assert [line.partition(" (")[0] for line in lines] == [
        f"scene {scene}, after {place}"
        for scene in (0, 1)
        for place in ("main/draw 1", "bent/perturb 1", "bent/perturb 2")
    ]


@pytest.mark.parametrize("name", ["bump", "bent/perturb 2"])
def test_one_pass_is_chosen_by_its_kind_or_place(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (line,) = printed(capsys, name)
    assert "perturb with bump" in line
    assert "`bent`" in line


def test_an_unknown_pass_is_refused_with_those_that_there_are() -> None:
    with pytest.raises(roadlang.DiagnosticError, match="RL930") as caught:
        PassPrinter(roadlang.loads(BENDS).scenario, "bmp")
    assert "did you mean `bump`?" in str(caught.value)


def test_compile_prints_passes_beside_its_json(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli.main import run

    monkeypatch.chdir(tmp_path)
    Path("scene.rl").write_text(BENDS)
    assert run(["compile", "scene.rl", "--print-after", "sine", "--json"]) == 0
    done = capsys.readouterr()
    assert json.loads(done.out)["diagnostics"] == []
    assert "scene 0, after bent/perturb 1 (perturb with sine): `bent`" in done.err
    assert run(["compile", "scene.rl", "--print-after", "cosine"]) == 2


def test_looking_changes_no_scene() -> None:
    seen: list[Any] = []
    loaded = roadlang.loads(BENDS)
    watched = loaded.sample(3, seed=4, jobs=2, after_pass=lambda *found: seen.append(found))
    plain = loaded.sample(3, seed=4)
    assert [scene.to_json() for scene in watched] == [scene.to_json() for scene in plain]
    assert len(seen) == 9


def test_a_line_says_how_far_a_road_is_displaced_and_how_it_bends(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A wave of 2 m over 100 m bends by up to 2 (2 pi / 100)^2 = 0.0079/m."""
    text = (
        "road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] }, width: 7m }\n"
        "road bent from main { perturb with sine { amplitude: 2m, wavelength: 100m } }\n"
    )
    loaded = roadlang.loads(text)
    loaded.sample(1, after_pass=PassPrinter(loaded.scenario, "all"))
    first, second = capsys.readouterr().err.splitlines()
    assert first.endswith(": 100.00 m")
    assert "`bent`, 100.39 m at 101 stations, displaced by up to 2 m" in second
    assert second.endswith("curvature up to 0.00789/m, width 7 to 7 m")
