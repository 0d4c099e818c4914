"""What cannot be built of narrow forks: which problems have a length, and which only a place."""

from __future__ import annotations

from roadlang.geometry.junctions.model import JunctionPlan, Problem
from roadlang.geometry.junctions.plan import PlanOptions
from tests.geometry.junctions.crossings_of_roads import plan_of, star

LENGTHS = {"overlap", "vanished", "outside"}
FORKS = [(0, 10), (0, 15, 180), (0, 8, 16), (0, 20, 40, 60), (0, 170, 350)]


def plan(fork: tuple[int, ...], length: float) -> JunctionPlan:
    network = star(*map(float, fork), length=length)
    return plan_of(network, [3] * len(network.edges), [], PlanOptions())


def problems() -> list[Problem]:
    return [
        p for fork in FORKS for length in (6.0, 12.0, 250.0) for p in plan(fork, length).problems
    ]


def test_overlaps_and_roads_that_vanish_have_a_length_and_the_others_none() -> None:
    found = problems()
    assert {p.kind for p in found} >= {"vanished", "stuck", "outside", "overlap", "sweep"}
    for problem in found:
        assert (problem.amount > 0.0) == (problem.kind in LENGTHS)
        assert problem.edges
