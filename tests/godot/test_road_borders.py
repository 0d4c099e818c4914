"""Lines and borders of built roads: no folds, no cut dashes, no gaps at junctions."""

from __future__ import annotations

import struct
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang.scenes.sampling import SamplingResult
from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import line_of
from roadlang_godot.build.road_mesh import road_parts
from roadlang_godot.build.unfolded_border import unfolded
from roadlang_godot.net.protocol import Message
from tests.godot.godot_scenes import bend, pieces, road, scene, straight
from tests.scenes.test_junction_paint import SIDEWALKS, crossing


@settings(max_examples=20)
@given(st.floats(1.5, 3.2), st.floats(40.0, 130.0), st.booleans())
def test_borders_in_tight_bends_do_not_fold(radius: float, degrees: float, is_left: bool) -> None:
    """A road 7 m wide: the inner border, 3.5 m off, would run back."""
    tight = road(
        "main", pieces(straight(15), bend(radius if is_left else -radius, degrees), straight(15))
    )
    line = line_of(tight)
    s = np.linspace(0.0, line.length, 200)
    ahead = line.at(0.5 * (s[:-1] + s[1:]))[1]
    direction = np.stack([np.cos(ahead), np.sin(ahead)], axis=-1)
    folded = 0
    for border in line.edges(s):
        free = unfolded(border, ahead)
        runs = (np.diff(free, axis=0) * direction).sum(axis=1)
        assert runs.min() > -1e-6
        assert np.array_equal(free[[0, -1]], border[[0, -1]])
        folded += not np.array_equal(free, border)
    assert folded == 1


def test_a_border_that_runs_back_without_crossing_itself_is_cut_off_in_the_middle() -> None:
    border = np.array([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.5, 0.0), (3.0, 0.0)])
    assert unfolded(border, np.zeros(4))[:, 0].tolist() == [0.0, 1.0, 1.75, 1.75, 3.0]


def test_the_dashes_of_a_road_with_open_ends_are_not_stretched() -> None:
    part = road_parts(line_of(road("main", pieces(straight(95)))), 1, SceneOrigin())[0]
    first, step = struct.unpack_from("<ff", part.body, 7)
    assert (first, step) == pytest.approx((0.0, 2.5))


def test_sidewalks_go_on_around_the_corners_of_a_junction(
    sample: Callable[..., SamplingResult],
) -> None:
    """Each of the four corners has a strip that begins and ends where those of the roads do."""
    made, _ = crossing(sample, SIDEWALKS)
    parts = layout_of(made).parts
    ends, found = [], []
    for part in parts:
        if part.kind == Message.SEGMENT:
            border = np.frombuffer(part.content, "<f4").reshape(-1, 2, 3)
            if part.label.startswith("sidewalk at junction"):
                found.append(border)
            elif border[0, 0, 1] > 0.1:
                ends += [border[0].mean(axis=0), border[-1].mean(axis=0)]
    assert len(found) == 4
    for strip in found:
        for face in (strip[0], strip[-1]):
            away = np.hypot(*(np.array(ends) - face.mean(axis=0)).T[[0, 2]])
            assert away.min() < 0.05
        assert strip[1:-1, :, 1].min() == pytest.approx(0.03)


def test_of_two_roads_that_cross_one_lies_on_top() -> None:
    along = road("a", pieces(straight(40)))
    across = road("b", pieces(straight(40), start=(20.0, -20.0), heading=1.57))
    heights = {
        part.label[0]: np.frombuffer(part.content, "<f4").reshape(-1, 3)[:, 1]
        for part in layout_of(scene(along, across)).parts
        if part.kind == Message.SEGMENT
    }
    assert (heights["a"] == 0.0).all()
    assert (heights["b"] == np.float32(0.005)).all()
