"""Formulas of scene files whose windows hold no sample: warned of, and failed if strict."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang import stl
from roadlang.diagnostics import Diagnostic
from roadlang.judging.window_warnings import JudgedAxis, window_warnings
from roadlang.session.scene_set import NoSceneError
from roadlang.stl.formula.evaluation_options import EvaluationOptions

ROAD = """
road main { draw with segments { pieces: [straight(100m)] } }
road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 60m..200m } }
"""
DRIVE = """
agent ego is car on main at 5m { drive with pure_pursuit { speed: 12m/s } }
simulate with builtin { duration: 1s }
"""
BETWEEN = "[0.2m, 0.8m] (deviation(bent, main) > 50m)"
BEYOND = "[200m, 300m] (deviation(bent, main) > 50m)"


def loaded(tmp_path: Path, *statements: str) -> roadlang.LoadedScenario:
    file = tmp_path / "scene.rl"
    file.write_text(ROAD + DRIVE + "\n".join(statements))
    return roadlang.load(file)


def told(diagnostics: tuple[Diagnostic, ...]) -> list[tuple[str, int]]:
    """Codes and lines of what is said of windows."""
    windows = [found for found in diagnostics if found.code.startswith("RL3")]
    return [(found.code, found.span.line if found.span else 0) for found in windows]


def test_windows_over_roads_are_warned_of_once_with_their_place(tmp_path: Path) -> None:
    scenes = loaded(
        tmp_path,
        f"require a: always{BETWEEN}",
        f"expect b: not eventually{BEYOND}",
        "require c: always[0m, 1m] (deviation(bent, main) < 50m)",
    ).sample(3, seed=1)
    assert told(scenes.diagnostics) == [("RL308", 7), ("RL313", 8)]
    assert any("road `bent`" in found.message for found in scenes.diagnostics)


def test_a_strict_requirement_rejects_what_is_vacuous(tmp_path: Path) -> None:
    kept = loaded(tmp_path, f"require a: always{BETWEEN}").sample(2, seed=1)
    assert all(scene.requirements["a"].satisfied for scene in kept)
    strict = loaded(tmp_path, f"require a: always{BETWEEN} {{ strict: true }}")
    with pytest.raises(NoSceneError):
        strict.sample(1, seed=1)
    # The bounds of a signal alone do not show that a window holds a sample.
    certain = "require a: always[0.2m, 0.8m] (deviation(bent, main) < 50m) { strict: true }"
    with pytest.raises(NoSceneError):
        loaded(tmp_path, certain).sample(1, seed=1)
    wide = "require a: always[0m, 0.8m] (deviation(bent, main) < 50m) { strict: true }"
    assert len(loaded(tmp_path, wide).sample(2, seed=1)) == 2


@pytest.mark.parametrize(("strict", "satisfied"), [("false", True), ("true", False)])
def test_windows_over_drives_are_warned_of_and_fail_if_strict(
    tmp_path: Path, strict: str, satisfied: bool
) -> None:
    scenes = loaded(
        tmp_path,
        f"expect far: always[5s, 6s] (ego.speed > 99m/s) {{ strict: {strict} }}",
        f"expect narrow: always[0.012s, 0.02s] (ego.speed > 99m/s) {{ strict: {strict} }}",
        "expect fair: always (ego.speed > 1m/s) { strict: true }",
    ).sample(2, seed=1)
    drives = scenes.run()
    assert told(drives.diagnostics) == [("RL313", 7), ("RL308", 8)]
    for drive in drives:
        found = [drive.verdicts[name].satisfied for name in ("far", "narrow", "fair")]
        assert found == [satisfied, satisfied, True]


def test_a_search_for_failures_warns_of_windows_over_roads_and_drives(tmp_path: Path) -> None:
    text = DRIVE.replace("12m/s", "(8m/s)..(12m/s)")
    file = tmp_path / "scene.rl"
    expectations = (
        f"expect along: always{BETWEEN}",
        "expect far: always[5s, 6s] (ego.speed > 99m/s)",
        "expect narrow: always[0.012s, 0.02s] (ego.speed > 99m/s)",
        "expect never: always (ego.speed > 99m/s)",
    )
    for count, warned in ((3, {("RL308", 7), ("RL308", 9), ("RL313", 8)}),
                          (4, {("RL308", 7), ("RL308", 9)})):  # fmt: skip
        # Where every drive fails, each may have ended before a window of another expectation.
        file.write_text(ROAD + text + "\n".join(expectations[:count]))
        assert set(told(roadlang.load(file).falsify(evaluations=3).diagnostics)) == warned


@pytest.mark.parametrize(
    ("ends", "said"),
    [
        ([5.0], "drive 0"),
        ([5.0, 6.0], "drive 0 and 1 more"),
        ([5.0, 6.0, 7.0], "drive 0 and 2 more"),
    ],
)
def test_windows_beyond_the_end_of_all_drives_are_warned_of_once(
    ends: list[float], said: str
) -> None:
    formula = stl.parse("always[10, 20] (x > 0)")
    axes = [JudgedAxis(f"drive {n}", np.arange(end + 1.0)) for n, end in enumerate(ends)]
    (found,) = window_warnings(formula, EvaluationOptions(), axes)
    assert found.code == "RL313"
    assert f"{said}" in found.message
    longer = JudgedAxis("a long one", np.arange(12.0))
    assert not list(window_warnings(formula, EvaluationOptions(), [*axes, longer]))
    assert not list(window_warnings(formula, EvaluationOptions(), []))


def test_windows_between_samples_are_warned_of_for_each_axis_unless_they_are_filled() -> None:
    formula = stl.parse("always[1.2, 1.8] (x > 0)")
    axes = [JudgedAxis("coarse", np.arange(9.0)), JudgedAxis("fine", np.arange(0.0, 9.0, 0.5))]
    (found,) = window_warnings(formula, EvaluationOptions(), axes)
    assert found.code == "RL308"
    assert "coarse" in found.message
    held = EvaluationOptions(semantics="held")
    assert not list(window_warnings(formula, held, axes))
