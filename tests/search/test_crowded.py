"""A scene in which things find no room is given up after the same attempt however it is sampled."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from roadlang.ir.encoding import to_json
from roadlang.scenes.sampling import SamplingResult
from roadlang.search.effort import CROWDED, FEWEST_CROWDED, crowded_attempts
from roadlang.session.loading import loads
from roadlang.world.index import index_scenario
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]

# The second car clears the first in a few percent of the draws, so that some scenes find one too
# late. What is drawn by name is not drawn again to place a car.
CROWD = """
road lot { draw with waypoints { points: [(0m, 0m), (100m, 0m)] } width: 3m }
let spot = 45.2m..55.2m
agent first is car on lot at 50m
agent second is car on lot at spot
"""
STEERED = (
    CROWD
    + STRAIGHT
    + """
road bent from main { perturb with sine { amplitude: 0m..8m, wavelength: 60m } }
require nearly_straight: always (deviation(bent, main) < 0.02m)
sample with guided
"""
)
MANY = 24
_known: dict[tuple[str, int], dict[int, str | None]] = {}


def outcome(result: SamplingResult, n: int) -> dict[int, str | None]:
    """The bytes of each scene that was asked for; None of those given up."""
    found: dict[int, str | None] = dict.fromkeys(range(n))
    return found | {scene.index: to_json(scene) for scene in result.scenes}


def of_many(sample: Sample, text: str, seed: int) -> dict[int, str | None]:
    """The same of `MANY` scenes."""
    if (text, seed) not in _known:
        _known[text, seed] = outcome(sample(text, MANY, seed=seed), MANY)
    return _known[text, seed]


@pytest.mark.parametrize("text", [CROWD, STEERED], ids=["random", "guided"])
@settings(
    max_examples=3, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(n=st.integers(1, MANY // 2), seed=st.integers(0, 1))
def test_the_number_of_scenes_does_not_decide_which_are_given_up(
    sample: Sample, text: str, n: int, seed: int
) -> None:
    expected = of_many(sample, text, seed)
    assert None in expected.values()
    assert outcome(sample(text, n, seed=seed), n) == {i: expected[i] for i in range(n)}


@pytest.mark.parametrize("size", [1, 7, 64, 4096])
def test_the_size_of_batches_does_not_decide_which_are_given_up(
    sample: Sample, monkeypatch: pytest.MonkeyPatch, size: int
) -> None:
    expected = of_many(sample, CROWD, 0)
    monkeypatch.setattr("roadlang.search.effort.BATCH", size)
    assert outcome(sample(CROWD, MANY), MANY) == expected


def test_attempts_that_are_steered_count_as_those_that_are_not(sample: Sample) -> None:
    """A scene is given up after as many for want of room, wherever they were drawn."""
    result = sample(STEERED.replace("45.2m..55.2m", "49m..51m"), 1)
    rejected = {row.name: row.rejected for row in result.table}
    assert result.missing == (0,)
    assert rejected["second"] == CROWDED


def test_the_table_counts_no_attempt_after_a_scene_was_given_up(sample: Sample) -> None:
    result = sample(CROWD, MANY)
    crowded = sum(row.rejected for row in result.table)
    assert crowded == result.candidates - result.accepted
    assert crowded >= CROWDED * len(result.missing)
    assert all(scene.provenance.attempt < CROWDED for scene in result.scenes)


@pytest.mark.slow
@pytest.mark.parametrize("text", [CROWD, STEERED], ids=["random", "guided"])
def test_workers_do_not_decide_which_are_given_up(sample: Sample, text: str) -> None:
    n = 40
    assert outcome(sample(text, n, jobs=2), n) == outcome(sample(text, n, jobs=1), n)


@pytest.mark.parametrize(
    ("counts", "attempts"),
    [
        ((), CROWDED), ((400,), CROWDED), ((300, 500), 20), ((5000,), FEWEST_CROWDED),
        (("integer(0, 800)",), 20),
    ],
)  # fmt: skip
def test_a_scene_of_many_copies_is_given_up_sooner(
    counts: tuple[int | str, ...], attempts: int
) -> None:
    """Each attempt takes longer, and all are more alike. Of a drawn count its most decides."""
    objects = [
        f"object trees{number} is tree on main at 0%..100% {{ count: {count}, side: left }}\n"
        for number, count in enumerate(counts)
    ]
    loaded = loads(STRAIGHT + "".join(objects))
    assert crowded_attempts(index_scenario(loaded.scenario, loaded.registry)) == attempts
