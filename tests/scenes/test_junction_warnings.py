"""What could not be built at junctions is said, with the roads by their numbers."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.geometry import network_of_polylines
from roadlang.geometry.junctions.plan import plan_junctions
from roadlang.scenes.sampling import SamplingResult
from tests.geometry.junctions.crossings_of_roads import sections_of

Sample = Callable[..., SamplingResult]
PLAN = '''
image plan from """
ROWS
""" { scale: 4m/px, legend: { "#": road } }
network town from plan
network bent from town { perturb with sine { amplitude: 0.2m..0.5m, wavelength: 40m } }
'''
STUB = "........#.......\n################\n................"
CROSSING = "...#....\n...#....\n...#....\n########\n...#....\n...#....\n...#...."


def said(sample: Sample, rows: str) -> list[tuple[str, str, str]]:
    result = sample(PLAN.replace("ROWS", rows), n=2)
    return [(w.code, w.severity, w.message) for w in result.warnings]


def test_a_plain_crossing_has_no_warnings(sample: Sample) -> None:
    assert said(sample, CROSSING) == []


def test_a_dead_end_inside_a_junction_is_named_once_for_all_networks_and_scenes(
    sample: Sample,
) -> None:
    (found,) = said(sample, STUB)
    assert found[:2] == ("RL437", "warning")
    assert found[2] == "road 1 of `town`, 4.0m long, lies inside junction 1"


def test_where_all_roads_lie_inside_a_junction_they_are_named_and_nothing_else_is_printed(
    sample: Sample, recwarn: pytest.WarningsRecorder
) -> None:
    rows = "#...#\n.#.#.\n..#..\n.#.#.\n#...#"
    text = PLAN.replace("ROWS", rows).replace("4m/px", "1m/px").split("network bent")[0]
    text = text.replace("from plan", "from plan { extract with auto { width: 5m } }")
    assert {warning.code for warning in sample(text).warnings} == {"RL437"}
    assert not recwarn.list


def test_a_warning_is_at_the_network(sample: Sample) -> None:
    (warning,) = sample(PLAN.replace("ROWS", STUB)).warnings
    assert warning.span is not None
    assert warning.span.text.startswith("network town")


def test_roads_that_cross_where_no_junction_is_are_found() -> None:
    network = network_of_polylines([[(0, 0), (100, 0)], [(50, -60), (50, 60)]])
    (problem,) = plan_junctions(network, sections_of(network)).problems
    assert (problem.kind, problem.junction, problem.edges) == ("overlap", -1, (1, 2))


def test_turns_that_no_vehicle_can_drive_are_refused_with_the_reason() -> None:
    """Two roads, 14 m apart, that end at the sides of a wide one: their ends cannot be joined."""
    lines = [[(0, 0), (60, 0)], [(0, 0), (59, 12)]]
    network = network_of_polylines(lines, 7.0)
    (junction,) = plan_junctions(network, sections_of(network)).junctions
    assert {round(abs(refusal.angle), 1) for refusal in junction.refused} == {2.9}
    assert all("room for a radius of" in refusal.reason for refusal in junction.refused)
