"""What cannot be built of narrow forks: which problems have a length, and which only a place."""

from __future__ import annotations

from roadlang.geometry import network_of_polylines
from roadlang.geometry.junctions.plan import PlanOptions
from roadlang.geometry.networks.junction_model import JunctionPlan, Problem
from tests.geometry.junctions.crossings_of_roads import plan_of, star

LENGTHS = {"overlap", "vanished", "outside"}
FORKS = [(0, 10), (0, 15, 180), (0, 8, 16), (0, 20, 40, 60), (0, 1, 180), (0, 2, 90)]


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


def test_a_dead_end_on_another_road_is_left_out_and_named() -> None:
    found = plan((0, 1, 180), 100.0)
    assert [(p.kind, p.edges) for p in found.problems] == [("vanished", (2,))]
    (junction,) = found.junctions
    assert junction.inside == (2,)
    assert {arm.edge for arm in junction.arms} == {1, 3}
    assert not junction.refused


def test_roads_that_part_late_begin_where_they_have_parted() -> None:
    """They leave two nodes, come together, cross 60 m on and are apart from 95 m on."""
    lines = [[(0, 0), (9, 0)], [(0, 0), (-80, 0)], [(9, 0), (80, 0)], [(0, 0), (10, 120)]]
    network = network_of_polylines([*lines, [(9, 0), (-1, 120)]], 6.0)
    found = plan_of(network)
    assert not found.problems
    (place,) = (junction for junction in found.junctions if len(junction.nodes) == 2)
    assert min(sorted(arm.trim for arm in place.arms)[-2:]) > 80.0


def test_what_is_left_of_a_road_between_two_nodes_of_a_place_is_swallowed() -> None:
    """A triangle of short streets is one surface, without a stub of road within it."""
    corners = [(0.0, 0.0), (18.0, 0.0), (9.0, 16.0)]
    away = [(-80.0, -40.0), (98.0, -40.0), (9.0, 100.0)]
    sides = [[corners[i], corners[(i + 1) % 3]] for i in range(3)]
    arms = [[corners[i], away[i]] for i in range(3)]
    found = plan_of(network_of_polylines([*sides, *arms], 6.0))
    (junction,) = found.junctions
    assert len(junction.inside) == 3
    assert not found.problems
