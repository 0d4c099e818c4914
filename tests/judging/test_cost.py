"""What a requirement is expected to cost at one station, in displacements."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.judging.acceptance import Acceptance
from tests.straight_road import STRAIGHT

ROADS = (
    STRAIGHT
    + "road bent from main { perturb with sine { amplitude: 0m..8m, wavelength: 60m..200m } }\n"
    + "road far { draw with waypoints { points: [(0m, 90m), (9m, 90m)] } }\n"
)


@pytest.mark.parametrize(
    ("formula", "cost"),
    [
        ("1m < length(main)", 5.0),
        ("always (curvature(bent) < 1/m)", 10.0 + 4.0),
        ("always (eventually[0m, 5m] curvature(bent) < 1/m)", 10.0 + 2 * 4.0),
        ("always (curvature(bent) < 1/m and width(bent) > 1m)", 10.0 + 1.0 + 4.0),
        ("always (deviation(bent, main) < 99m)", 2.0 + 4.0),
        ("always (distance(bent, main) < 9m)", 3.0 + 4.0),
        ("always (distance(bent, far) > 1m)", 3.0 * 4000.0 + 4.0),
    ],
)
def test_kinds_say_what_they_cost_and_temporal_operators_add_to_it(
    formula: str, cost: float, acceptance: Callable[[str], Acceptance]
) -> None:
    """The nearest point of a road with another root takes longer than all else."""
    found = acceptance(ROADS + f"require this: {formula}\n").requirements
    assert {each.name: each.cost for each in found if not each.implied} == {"this": cost}
