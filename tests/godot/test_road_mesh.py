"""Roads become strips: whole, without gaps, fine enough, and each in one datagram."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.line import RoadSamples, line_of
from roadlang_godot.build.road_mesh import SAG, TURN, road_parts, stations
from roadlang_godot.net import protocol
from roadlang_godot.net.scene_part import ScenePart
from tests.godot.godot_scenes import bend, bends, pieces, road, straight

radii = st.floats(8, 400) | st.floats(-400, -8)


def strip(thing: ScenePart) -> np.ndarray:
    """(n, 2, 3) left and right edge points."""
    return np.frombuffer(thing.content, dtype="<f4").reshape(-1, 2, 3)


@settings(max_examples=25)
@given(radii, st.floats(10, 170), st.floats(5, 300))
def test_neighbors_share_their_corners_exactly(radius: float, turn: float, run: float) -> None:
    line = line_of(road("r", pieces(straight(run), bend(radius, turn), straight(run))))
    strips = [strip(thing) for thing in road_parts(line, 1, SceneOrigin())]
    for one, following in pairwise(strips):
        assert np.array_equal(one[-1], following[0])


@settings(max_examples=25)
@given(radii, st.floats(10, 170))
def test_every_piece_fits_a_datagram_that_no_network_splits(radius: float, turn: float) -> None:
    line = line_of(road("r", pieces(straight(250), bend(radius, turn), straight(30))))
    for thing in road_parts(line, 1, SceneOrigin()):
        whole = protocol.pack(thing.kind, 1, 1, thing.message(0, 1))
        assert len(whole) <= protocol.BULK_DATAGRAM


@given(st.floats(15, 400), st.floats(20, 170))
def test_chords_stay_near_the_curve(radius: float, turn: float) -> None:
    line = line_of(road("r", pieces(bend(radius, turn))))
    for s in stations(line, 0.0, line.length):
        middle = line.at((s[:-1] + s[1:]) / 2)[0]
        ends = line.at(s)[0]
        away = np.hypot(*((ends[:-1] + ends[1:]) / 2 - middle).T)
        assert away.max() < 1.5 * SAG


@given(st.floats(6, 30), st.floats(60, 170))
def test_tight_bends_have_no_facets_that_can_be_seen(radius: float, turn: float) -> None:
    line = line_of(road("r", pieces(straight(20), bend(radius, turn), straight(20))))
    corners = np.concatenate([line.at(s[:-1])[0] for s in stations(line, 0.0, line.length)])
    chords = np.diff(corners, axis=0)
    turns = np.diff(np.unwrap(np.arctan2(chords[:, 1], chords[:, 0])))
    assert np.abs(turns).max() < 1.2 * TURN


def test_the_pieces_cover_the_road_and_no_more() -> None:
    line = line_of(bends())
    covered = list(stations(line, 0.0, line.length))
    assert covered[0][0] == 0.0
    assert covered[-1][-1] == pytest.approx(line.length)
    assert all(a[-1] == b[0] for a, b in pairwise(covered))


def test_the_strip_is_as_wide_as_the_road() -> None:
    line = line_of(road("r", pieces(straight(50), bend(40, 90)), width=6.5))
    for thing in road_parts(line, 1, SceneOrigin()):
        edges = strip(thing)
        assert np.hypot(*(edges[:, 0] - edges[:, 1])[:, [0, 2]].T) == pytest.approx(6.5, abs=1e-3)


def test_north_is_minus_z_and_the_left_edge_is_left() -> None:
    line = line_of(road("east", pieces(straight(20))))
    left, right = strip(road_parts(line, 1, SceneOrigin())[0])[0]
    assert left == pytest.approx([0.0, 0.0, -3.5])
    assert right == pytest.approx([0.0, 0.0, 3.5])


def test_a_closed_road_ends_where_it_begins() -> None:
    ring = road("ring", pieces(bend(40, 359)), closed=True)
    strips = [strip(thing) for thing in road_parts(line_of(ring), 1, SceneOrigin())]
    assert strips[0][0] == pytest.approx(strips[-1][-1], abs=1e-3)


def test_a_scene_far_from_the_origin_is_as_exact_as_one_near_it() -> None:
    near = line_of(road("r", pieces(straight(90), bend(30, 90))))
    far = line_of(road("r", pieces(straight(90), bend(30, 90), start=(4e5, 5e6))))
    assert isinstance(far, RoadSamples)
    here = strip(road_parts(near, 1, SceneOrigin())[0])
    there = strip(road_parts(far, 1, SceneOrigin(4e5, 5e6))[0])
    assert there == pytest.approx(here, abs=1e-3)
