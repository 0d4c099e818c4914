"""Networks corrected by hand: roads are dismissed, drawn and confirmed, and stay joined."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang.geometry import GeometryError, RoadNetwork, network_of_polylines
from roadlang.geometry.networks.corrections import Corrected, Corrections, corrected

Points = Sequence[tuple[float, float]]

TEE = ([(0, 0), (50, 0), (100, 0)], [(100, 0), (150, 0), (200, 0)], [(100, 0), (100, 100)])
"""Three roads 6 m wide that meet at (100, 0)."""
ANGLES = np.linspace(0.0, 2.0 * np.pi, 61)
RING = [(100.0 * np.cos(a), 100.0 * np.sin(a)) for a in ANGLES]
ROUND = 200.0 * np.pi


def network(*lines: Points) -> RoadNetwork:
    return network_of_polylines([np.array(line, dtype=float) for line in lines], 6.0)


def changed(
    *lines: Points,
    drawn: Sequence[Points] = (),
    dismissed: Sequence[Points] = (),
    confirmed: Points = (),
) -> Corrected:
    return corrected(
        network(*lines),
        Corrections(
            tuple(np.array(line, dtype=float) for line in drawn),
            tuple(np.array(line, dtype=float) for line in dismissed),
            np.array(confirmed, dtype=float).reshape(-1, 2),
        ),
    )


def lengths(found: Corrected) -> list[float]:
    return sorted(round(edge.length, 1) for edge in found.network.edges)


def test_a_dismissed_branch_leaves_one_road_where_it_ended() -> None:
    found = changed(*TEE, dismissed=[[(101, 60)]])
    (road,) = found.network.edges
    assert road.length == pytest.approx(200.0)
    assert len(found.network.nodes) == 2


def test_roads_that_turn_at_a_former_junction_stay_two() -> None:
    assert lengths(changed(*TEE, dismissed=[[(30, 0)]])) == [100.0, 100.0]


def test_a_part_is_cut_out_and_all_else_stays() -> None:
    found = changed(*TEE, dismissed=[[(60, 1), (20, -1)]])
    assert lengths(found) == [20.0, 40.0, 100.0, 100.0]
    assert len(found.network.components) == 2


def test_a_part_that_nearly_reaches_a_node_reaches_it() -> None:
    found = changed(*TEE, dismissed=[[(60, 0), (96, 0)]])
    assert lengths(found) == [60.0, 200.0] or lengths(found) == [60.0, 100.0, 100.0]


def test_of_a_ring_the_shorter_part_is_cut_out() -> None:
    for points in ([(100, 10), (100, -10)], [(100, -10), (100, 10)], [(-100, 10), (-100, -10)]):
        (road,) = changed(RING, dismissed=[points]).network.edges
        assert road.length == pytest.approx(ROUND - 200.0 * np.arctan(0.1), abs=0.5)
        assert not road.curve.closed


def test_a_drawn_road_joins_what_it_ends_at_and_what_it_crosses() -> None:
    found = changed(*TEE, [(0, 200), (200, 200)], drawn=[[(50, 2), (50, 100), (50, 300)]])
    degrees = sorted(found.network.degree(node.id) for node in found.network.nodes)
    assert degrees == [1, 1, 1, 1, 1, 1, 3, 3, 4]
    assert len(found.network.components) == 1
    assert lengths(found) == [50.0, 50.0, 50.0, 100.0, 100.0, 100.0, 150.0, 200.0]


def test_a_drawn_road_ends_at_a_node_that_is_near() -> None:
    found = changed(*TEE, drawn=[[(100, -60), (101, -5)]])
    assert sorted(found.network.degree(node.id) for node in found.network.nodes)[-1] == 4


def test_a_road_is_drawn_across_a_ring() -> None:
    found = changed(RING, drawn=[[(-150, 0), (150, 0)]])
    assert sum(edge.length for edge in found.network.edges) == pytest.approx(ROUND + 300, abs=0.5)
    assert [found.network.degree(node.id) for node in found.network.nodes].count(4) == 2
    assert len(found.network.components) == 1


def test_a_drawn_ring_is_a_ring() -> None:
    found = changed(*TEE, drawn=[[(300, 0), (360, 60), (300, 120), (240, 60), (301, 2)]])
    assert [edge.curve.closed for edge in found.network.edges].count(True) == 1


def test_drawn_roads_are_as_wide_as_the_others_and_sure() -> None:
    found = changed(*TEE, drawn=[[(0, 300), (200, 300)]])
    (road,) = [edge for edge in found.network.edges if edge.length > 150.0]
    assert float(road.width.at(30.0)) == pytest.approx(6.0)
    assert road.confidence == 1.0


def test_points_that_are_on_no_road_are_named() -> None:
    found = changed(*TEE, dismissed=[[(20, 40)]], confirmed=[(20, -50), (20, 3)])
    assert found.missed == ((20.0, 40.0), (20.0, -50.0))
    assert lengths(found) == [100.0, 100.0, 100.0]


def test_a_road_between_one_place_and_itself_is_refused() -> None:
    with pytest.raises(GeometryError):
        changed(*TEE, drawn=[[(30, 0), (30, 0)]])


places = st.tuples(st.integers(-2, 22), st.integers(-6, 12)).map(
    lambda p: (10.0 * p[0], 10.0 * p[1])
)
strokes = st.lists(places, min_size=2, max_size=4, unique=True)


@settings(max_examples=15)
@given(
    st.lists(strokes, max_size=2), st.lists(st.lists(places, min_size=1, max_size=2), max_size=2)
)
def test_whatever_is_said_the_network_holds_together(
    drawn: list[Points], dismissed: list[Points]
) -> None:
    """RoadNetwork itself refuses roads that do not end at their nodes."""
    try:
        found = changed(*TEE, drawn=drawn, dismissed=dismissed)
    except GeometryError as error:
        if "the same place" in str(error):
            return
        raise
    assert all(edge.length > 0.0 for edge in found.network.edges)
    assert all(found.network.degree(node.id) for node in found.network.nodes)
    if not drawn:
        assert found.network.length <= 300.0 + 1e-6
