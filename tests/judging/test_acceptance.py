"""Requirements are tried in the order of what they cost, on the survivors of those before."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.judging.acceptance import ACCEPTED, Acceptance
from roadlang.world.placement.placement import placed, placed_tries
from tests.straight_road import STRAIGHT

Requirements = Callable[[str], Acceptance]
BENT = "road bent from main { perturb with sine { amplitude: 0m..8m, wavelength: 60m..200m } }\n"
DRAWN = """
param end = 90m..200m
road main { draw with waypoints { points: [(0m, 0m), (end, 0m)] } }
road bent from main { perturb with sine { amplitude: 0m..8m, wavelength: 60m..200m } }
"""
RULES = """
require near: always (deviation(bent, main) < 5m)
require calm: always (abs(curvature(bent)) < 0.004/m)
"""


def batch(acceptance: Acceptance, count: int = 40) -> CandidateBatch:
    return CandidateBatch(acceptance.scenario, 3, np.zeros(count, np.int64), np.arange(count))


def test_cheap_requirements_are_tried_first(acceptance: Requirements) -> None:
    """To find the nearest point of another root takes longer than all else."""
    text = STRAIGHT + BENT + "road far { draw with waypoints { points: [(0m, 90m), (9m, 90m)] } }\n"
    text += "require apart: always (distance(bent, far) > 1m)\n"
    text += "require patient: always (curvature(bent) > -1/m until[1m, 2m] curvature(bent) < 1/m)\n"
    text += "require calm: always (curvature(bent) < 1/m)\nrequire fit: 1m < length(main)\n"
    text += "require near: always (deviation(bent, main) < 99m)\n"
    names = [found.name for found in acceptance(text).requirements if not found.implied]
    assert names == ["fit", "near", "calm", "patient", "apart"]


def test_what_rejects_a_candidate_is_the_first_requirement_that_fails(
    acceptance: Requirements,
) -> None:
    requirements = acceptance(STRAIGHT + BENT + RULES)
    measured = requirements.measure(batch(requirements))
    result = requirements.judge(batch(requirements))
    first = np.where(measured.satisfied.all(axis=0), ACCEPTED, (~measured.satisfied).argmax(axis=0))
    assert (result.rejected_by == first).all()
    assert set(first) == {ACCEPTED, 1, 2}  # 0: it does not fold
    needed = ~np.isnan(result.rho)
    assert (result.rho[needed] == measured.rho[needed]).all()


def test_roads_with_stations_of_their_own_are_measured_one_by_one(acceptance: Requirements) -> None:
    requirements = acceptance(DRAWN + RULES)
    assert requirements.has_varying_stations
    candidates = batch(requirements, 12)
    together = requirements.measure(candidates)
    for row in range(12):
        alone = requirements.measure(candidates.take(np.array([row])))
        assert (together.rho[:, row] == alone.rho[:, 0]).all()
        assert (together.satisfied[:, row] == alone.satisfied[:, 0]).all()
    result = requirements.judge(candidates)
    assert (result.accepted == together.satisfied.all(axis=0)).all()


PLACED = (
    STRAIGHT
    + """
let spot = 42m..58m
agent first is car on main at 50m { lane: -1 }
agent second is car on main at spot { lane: -1 }
"""
)


def test_of_each_scene_placements_are_judged_until_one_passes(acceptance: Requirements) -> None:
    """Placing is judged last: of the candidates of a scene that satisfy all else, up to the first
    in which everything has room."""
    requirements = acceptance(PLACED)
    last = [n for n, requirement in enumerate(requirements.requirements) if requirement.last]
    scenes = np.repeat(np.arange(6), 8)
    candidates = CandidateBatch(requirements.scenario, 3, scenes, np.tile(np.arange(8), 6))
    everything = requirements.judge(candidates)
    wanted = requirements.judge(candidates, scenes)
    assert {True, False} == set(everything.accepted.tolist())
    for scene in range(6):
        rows = np.flatnonzero(scenes == scene)
        first = int(np.argmax(everything.accepted[rows]))
        until, after = rows[: first + 1], rows[first + 1 :]
        assert (wanted.rejected_by[until] == everything.rejected_by[until]).all()
        assert wanted.accepted[after].all()
        assert np.isnan(wanted.rho[last][:, after]).all()


CROWDED = STRAIGHT + "agent cars is car on main at 0m..60m { count: 6 }\n"


def test_the_result_says_at_which_try_each_copy_was_placed(acceptance: Requirements) -> None:
    """Whoever places the copies again at these tries finds the same places without a search."""
    requirements = acceptance(CROWDED)
    candidates = batch(requirements)
    result = requirements.judge(candidates)
    rows = np.flatnonzero(result.accepted)
    tries = np.stack([result.tries_of(row)["cars"] for row in rows.tolist()])
    assert tries.shape == (len(rows), 6)
    assert tries.any()
    cars = requirements.scenario.actors["cars"]
    again = CandidateBatch(
        requirements.scenario,
        3,
        candidates.scenes[rows],
        candidates.attempts[rows],
        known_tries={"cars": tries},
    )
    assert (placed_tries(cars, again) == tries).all()
    searched, repeated = placed(cars, candidates.take(rows)), placed(cars, again)
    assert (searched.x == repeated.x).all()
    assert (searched.y == repeated.y).all()


def test_a_candidate_that_failed_before_anything_was_placed_has_no_tries(
    acceptance: Requirements,
) -> None:
    requirements = acceptance(CROWDED + BENT + RULES)
    result = requirements.judge(batch(requirements))
    unplaced = [row for row in range(40) if not result.tries_of(row)]
    assert 0 < len(unplaced) < 40
    assert not result.accepted[unplaced].any()
