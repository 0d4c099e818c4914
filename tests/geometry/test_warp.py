"""Places of a plane are moved: they land where they should, and roads stay smooth and joined."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import GeometryError, RoadNetwork
from roadlang.geometry.networks.polylines import network_of_polylines
from roadlang.geometry.networks.warp import Warp

LINES = [[(0, 0), (100, 0)], [(100, 0), (200, 20)], [(100, 0), (100, 90)]]
MOVE = st.tuples(st.floats(-25, 25), st.floats(-25, 25))


def network() -> RoadNetwork:
    return network_of_polylines(LINES, width=7.0)


@given(move=MOVE)
def test_a_place_lands_where_it_is_moved_and_what_is_far_stays(move: tuple[float, float]) -> None:
    warp = Warp.of([(100.0, 0.0)], [move], 80.0)
    landed = warp.moved(np.array([[100.0, 0.0], [100.0, 80.0], [-5.0, 0.0]]))
    np.testing.assert_allclose(landed, [[100.0 + move[0], move[1]], [100.0, 80.0], [-5.0, 0.0]])


@given(move=MOVE, x=st.floats(20, 180), y=st.floats(-60, 60))
def test_an_origin_comes_to_lie_at_the_point(move: tuple[float, float], x: float, y: float) -> None:
    warp = Warp.of([(100.0, 0.0), (60.0, 20.0)], [(0.5 * move[0], 0.5 * move[1]), (3.0, 1.0)], 80.0)
    np.testing.assert_allclose(warp.moved(np.array(warp.origin_of((x, y)))), (x, y), atol=1e-3)


@given(move=MOVE)
def test_tangents_are_those_of_the_moved_line(move: tuple[float, float]) -> None:
    warp = Warp.of([(100.0, 0.0)], [move], 80.0)
    x = np.linspace(30.0, 170.0, 1401)
    line = np.stack([x, 0.1 * x], axis=-1)
    turned = warp.turned(line, np.broadcast_to([1.0, 0.1], line.shape))
    slope = np.gradient(warp.moved(line), x, axis=0)
    np.testing.assert_allclose(turned[1:-1], slope[1:-1], atol=1e-3)


@given(move=MOVE)
def test_roads_stay_joined_and_keep_their_lengths_elsewhere(move: tuple[float, float]) -> None:
    before = network()
    after = Warp.of([(100.0, 0.0)], [move], 70.0).network(before)
    ends = [tuple(edge.curve.at(np.array([0.0, edge.length])).ravel()) for edge in after.edges]
    assert len(ends) == len(before.edges)
    joint = next(node for node in after.nodes if after.degree(node.id) == 3)
    np.testing.assert_allclose(joint.position, (100.0 + move[0], move[1]), atol=1e-9)
    far = Warp.of([(0.0, 500.0)], [move], 70.0).network(before)
    assert [edge.curve for edge in far.edges] == [edge.curve for edge in before.edges]


def test_a_plane_that_would_fold_is_refused() -> None:
    with pytest.raises(GeometryError, match=r"at most 46\.5 m"):
        Warp.of([(0.0, 0.0)], [(47.0, 0.0)], 80.0)
    with pytest.raises(GeometryError, match="1 places, but 0 displacements"):
        Warp.of([(0.0, 0.0)], [], 80.0)


@pytest.mark.parametrize("apart", [0.0, 20.0, 40.0])
def test_moves_that_add_up_to_a_fold_are_refused(apart: float) -> None:
    at = [(-apart, 0.0), (0.0, 0.0), (apart, 0.0)]
    with pytest.raises(GeometryError, match="add up"):
        Warp.of(at, [(40.0, 0.0)] * 3, 80.0)
    Warp.of(at, [(12.0, 0.0)] * 3, 80.0)
    Warp.of([(-200.0, 0.0), (0.0, 0.0), (200.0, 0.0)], [(46.0, 0.0)] * 3, 80.0)
