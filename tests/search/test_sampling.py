"""What scenes come out does not depend on how they were searched for."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

from roadlang.ir.encoding import to_json
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BENT = (
    STRAIGHT
    + """
road bent from main {
  perturb with sine { amplitude: 0m..8m, wavelength: 60m..200m, phase: 0deg..360deg }
}
require drivable: always (abs(curvature(bent)) < 0.01/m)
agent ego is car on bent at 0%..40%
object trees is tree on bent at 0%..100% { count: integer(1, 4), side: left, offset: 2m..8m }
"""
)


def bytes_of(result: SamplingResult) -> list[str]:
    return [to_json(scene) for scene in result.scenes]


def test_two_runs_give_the_same_bytes(sample: Sample) -> None:
    assert bytes_of(sample(BENT, 4, seed=7)) == bytes_of(sample(BENT, 4, seed=7))


def test_another_seed_gives_other_scenes(sample: Sample) -> None:
    first, second = bytes_of(sample(BENT, 1, seed=1)), bytes_of(sample(BENT, 1, seed=2))
    assert first != second


@pytest.mark.parametrize("how", ["random", "halton", "guided"])
def test_the_first_scenes_of_many_are_those_of_few(sample: Sample, how: str) -> None:
    text = BENT + f"sample with {how}\n"
    assert bytes_of(sample(text, 3)) == bytes_of(sample(text, 20))[:3]


@pytest.mark.slow
@pytest.mark.parametrize("how", ["random", "halton", "guided"])
def test_workers_change_nothing(sample: Sample, how: str) -> None:
    text = BENT + f"sample with {how}\n"
    assert bytes_of(sample(text, 40, jobs=2)) == bytes_of(sample(text, 40, jobs=1))


def test_a_new_agent_does_not_change_the_road(sample: Sample) -> None:
    more = BENT + "agent lead is truck on bent at 50%..60%\n"
    assert sample(more, 3).scenes[2].roads == sample(BENT, 3).scenes[2].roads


def test_every_scene_satisfies_what_was_required(sample: Sample) -> None:
    for scene in sample(BENT, 12).scenes:
        (verdict,) = scene.requirements
        assert verdict.satisfied
        assert max(map(abs, scene.roads[1].curvature)) < 0.01
        assert verdict.robustness == pytest.approx(0.01 - max(map(abs, scene.roads[1].curvature)))


def test_the_table_counts_what_was_rejected(sample: Sample) -> None:
    result = sample(BENT, 12)
    (row,) = [row for row in result.table if row.name == "drivable"]
    assert row.rejected == result.candidates - 12
    assert row.share == pytest.approx(row.rejected / row.tried)
    assert row.line == 7
    assert "drivable: always (abs(curvature(bent)) < 0.01/m)" in result.table_text


def test_bounds_tell_the_impossible_without_a_single_candidate(sample: Sample) -> None:
    result = sample(BENT + "require far: eventually (deviation(bent, main) > 9m)\n")
    assert result.scenes == ()
    assert result.candidates == 0
    assert result.impossible == ("`eventually (deviation(bent, main) > 9m)`",)


def test_what_no_draw_can_change_is_impossible(sample: Sample) -> None:
    result = sample(STRAIGHT + "require long: length(main) > 1km\n", 5)
    assert result.impossible == ("`length(main) > 1km`",)
    assert result.wanted == 5
    assert sample(STRAIGHT + "require long: length(main) > 1km\n", None).wanted == 1


def test_the_unlucky_are_told_from_the_impossible(sample: Sample) -> None:
    text = BENT + "require thin: always (deviation(bent, main) < 0.0001m)\n"
    result = sample(text + "sample with random { attempts: 300 }\n", 4)
    assert result.scenes == ()
    assert result.impossible == ()
    assert result.candidates == 300
    assert result.missing == (0, 1, 2, 3)
    (thin,) = [row for row in result.table if row.name == "thin"]
    assert thin.best is not None
    assert thin.best < 0


def test_candidates_that_bounds_accept_count_as_tried_and_not_as_rejected(sample: Sample) -> None:
    result = sample(BENT + "require near: always (deviation(bent, main) < 9m)\n", 5)
    (near,) = [row for row in result.table if row.name == "near"]
    assert (near.tried, near.settled, near.rejected) == (result.candidates, result.candidates, 0)
    assert near.best in [scene.requirements[1].robustness for scene in result.scenes]


def test_the_best_robustness_is_that_of_an_accepted_scene_not_of_a_rejected_one(
    sample: Sample,
) -> None:
    near = "require near: always (deviation(bent, main) < 2m)\n"
    (row,) = sample(BENT.replace("require drivable", "expect drivable") + near, 3).table
    assert 0 < row.rejected < row.tried
    assert row.share < 1
    assert row.best is not None
    assert row.best > 0


def test_candidates_that_bounds_accept_have_no_best_robustness_without_a_scene(
    sample: Sample,
) -> None:
    """Of `near` only the robustness of candidates that it rejects is computed: no best one."""
    text = BENT + "require near: always (deviation(bent, main) < 2m)\n"
    thin = "require thin: always (abs(curvature(bent)) < 1e-9/m and deviation(bent, main) > 1m)\n"
    result = sample(text + thin + "sample with random { attempts: 200 }\n", 1)
    (row,) = [row for row in result.table if row.name == "near"]
    assert result.scenes == ()
    assert row.rejected < row.tried
    assert row.best is None
    line = next(line for line in result.table_text.splitlines() if line.startswith("near: "))
    assert re.split(" {2,}", line)[3] == "at least 0"


def test_a_grid_visits_every_combination_once(sample: Sample) -> None:
    text = (
        STRAIGHT
        + """
param speed = choice(8m/s, 12m/s)
param weather = choice("clear", "rain", "fog")
param far = 4m..12m
sample with grid { steps: 5 }
"""
    )
    scenes = sample(text, None).scenes
    seen = {(s.values["speed"], s.values["weather"], s.values["far"]) for s in scenes}
    assert len(scenes) == len(seen) == 2 * 3 * 5
    assert {values[2] for values in seen} == {4.0, 6.0, 8.0, 10.0, 12.0}


def diversity(result: SamplingResult) -> float:
    assert result.diversity is not None
    return result.diversity


def test_halton_leaves_fewer_gaps_than_chance(sample: Sample) -> None:
    text = STRAIGHT + "param a = 0..1\nparam b = 0..1\n"
    spread = {
        how: diversity(sample(text + f"sample with {how}\n", 64)) for how in ("random", "halton")
    }
    assert spread["halton"] > 1.2 * spread["random"]


def test_a_named_draw_is_one_and_fresh_draws_anew(sample: Sample) -> None:
    text = STRAIGHT + "param a = 0m..8m\nlet b = a\nlet c = fresh(a)\n"
    values = sample(text).scenes[0].values
    assert values["a"] == values["b"] != values["c"]


def test_guided_needs_far_fewer_candidates(sample: Sample) -> None:
    rare = (
        STRAIGHT
        + """
road bent from main {
  perturb with sine { amplitude: 0m..12m, wavelength: 40m..200m, phase: 0deg..360deg }
}
require far: eventually (deviation(bent, main) > 11.4m)
require calm: always (abs(curvature(bent)) < 0.012/m)
"""
    )
    plain, guided = sample(rare, 40), sample(rare + "sample with guided { fallback: never }\n", 40)
    assert plain.candidates > 60 * 40
    assert guided.candidates < plain.candidates / 8
    assert diversity(guided) > 0.6 * diversity(plain)


def test_progress_is_told(sample: Sample) -> None:
    steps: list[tuple[int, int]] = []
    sample(BENT, 20, progress=lambda done, total: steps.append((done, total)))
    assert steps[-1] == (20, 20)
    assert sorted(steps) == steps


def test_draws_of_copies_are_no_dimension_of_a_grid(sample: Sample) -> None:
    """There may be more copies than anybody wants to combine: each draws for itself."""
    text = STRAIGHT + "object trees is tree on main at 0%..100% { count: 3, side: left }\n"
    grid = "sample with grid { steps: 4 }\n"
    assert len(sample(text + grid, None).scenes) == 1
    drawn = "param wide = 1m..2m\nobject post is box at (wide, 3m)\n"
    scenes = sample(text + drawn + grid, None).scenes
    assert len(scenes) == 4
    assert len({scene.objects[0].start for scene in scenes}) == 4


def test_the_table_has_what_rejects_most_first(sample: Sample) -> None:
    """`near` is tried first, since it costs less, and rejects less."""
    text = BENT + "require near: always (deviation(bent, main) < 7m)\n"
    table = [row for row in sample(text, 12).table if not row.implied]
    assert [row.name for row in table] == ["drivable", "near"]
    assert table[0].rejected > table[1].rejected > 0
