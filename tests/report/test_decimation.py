"""Fewer points and shorter numbers stay near what they stand for."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roadlang import testing
from roadlang.geometry.curves.simplifying import all_simplified, simplified
from roadlang.report.decimation import deltas, samples_of
from roadlang.report.outlines import outline

NUMBERS = st.floats(-1e4, 1e4)
LINES = arrays(np.float64, st.tuples(st.integers(2, 40), st.just(2)), elements=NUMBERS)
TOLERANCE = 0.5


@given(LINES)
def test_a_simplified_line_stays_near_every_point(line: np.ndarray) -> None:
    kept = simplified(line, TOLERANCE)
    assert kept[0] == 0
    assert kept[-1] == len(line) - 1
    for first, last in pairwise(kept):
        a, chord = line[first], line[last] - line[first]
        length = np.hypot(*chord)
        for point in line[first + 1 : last] - a:
            gap = (
                abs(point[0] * chord[1] - point[1] * chord[0]) / length
                if length
                else np.hypot(*point)
            )
            assert gap <= TOLERANCE + 1e-6


@given(st.lists(LINES, max_size=4))
def test_lines_are_simplified_together_as_each_is_alone(lines: list[np.ndarray]) -> None:
    together = [kept.tolist() for kept in all_simplified(lines, TOLERANCE)]
    assert together == [simplified(line, TOLERANCE).tolist() for line in lines]


def test_points_on_a_straight_line_are_dropped() -> None:
    line = np.stack([np.linspace(0, 100, 500), np.linspace(0, 50, 500)], axis=-1)
    assert simplified(line, 0.1).tolist() == [0, 499]


@given(
    arrays(np.float64, st.integers(1, 50), elements=NUMBERS), st.sampled_from([1.0, 100.0, 1000.0])
)
def test_sums_of_deltas_are_the_values(values: np.ndarray, scale: float) -> None:
    found = np.cumsum(deltas(values, scale)) / scale
    assert np.abs(found - values).max() <= 0.5 / scale + 1e-9


@given(
    arrays(np.float64, st.integers(1, 30), elements=st.floats(-1e3, 1e3) | st.just(float("nan")))
)
def test_what_is_not_finite_repeats_what_was_before(values: np.ndarray) -> None:
    found = np.cumsum(deltas(values, 100.0)) / 100.0
    finite = np.isfinite(values)
    if not finite.any():
        assert len(found) == 0
        return
    assert np.abs(found[finite] - values[finite]).max() <= 0.005 + 1e-9
    for at in np.flatnonzero(~finite):
        assert (
            found[at] == found[at - 1]
            if finite[:at].any()
            else found[at] == found[np.argmax(finite)]
        )


@given(arrays(np.float64, st.integers(2, 2000), elements=NUMBERS), st.integers(2, 100), st.data())
def test_samples_keep_the_ends_the_extremes_and_the_moment(
    series: np.ndarray, most: int, data: st.DataObject
) -> None:
    moment = data.draw(st.integers(0, len(series) - 1))
    kept = samples_of(len(series), most, [series], [moment])
    assert {0, len(series) - 1, moment} <= set(kept.tolist())
    assert series[kept].min() == series.min()
    assert series[kept].max() == series.max()
    assert len(kept) <= most + 5
    assert (np.diff(kept) > 0).all()


def test_outlines_of_roads_stay_within_a_decimeter_with_few_points() -> None:
    bend = "road main { draw with segments { pieces: [arc(50m, 180deg)] }, width: 10m, lanes: 2 }"
    (scene,) = testing.sample(bend)
    ring = outline(scene.record.roads[0]).surface
    radii = np.hypot(ring[:, 0], ring[:, 1] - 50.0)
    np.testing.assert_allclose(np.minimum(abs(radii - 45.0), abs(radii - 55.0)), 0.0, atol=0.01)
    middles = (ring[1:] + ring[:-1]) / 2
    depth = np.hypot(middles[:, 0], middles[:, 1] - 50.0)
    chords = [min(abs(d - 45.0), abs(d - 55.0)) for d in depth if not 45.5 < d < 54.5]
    assert 0.05 < max(chords) <= 0.1 + 1e-3
    assert len(ring) < 70
