"""Numbers of a drawing: two decimals at most, written in bulk as they are one by one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from roadlang_standard.svg.markup import number, path_data
from roadlang_standard.svg.ribbon import ribbon_of
from roadlang_standard.svg.viewport import BoundingBox, bounds, fitted
from tests.backends.handmade_scenes import bend

PIXELS = st.floats(-1e12, 1e12) | st.floats(-2000.0, 2000.0) | st.integers(-400, 400).map(
    lambda eighths: eighths / 8.0
)  # fmt: skip


@given(st.lists(st.tuples(PIXELS, PIXELS), min_size=1))
@example([(0.125, -0.125), (-0.001, 0.0), (0.285, 1.005), (99.995, -99.995)])
def test_a_path_has_its_points_as_numbers_are_written(points: list[tuple[float, float]]) -> None:
    text = "L".join(f"{number(x)} {number(y)}" for x, y in points)
    assert path_data(np.array(points)) == f"M{text}"
    assert path_data(np.array(points), closed=True) == f"M{text}Z"


def test_a_part_of_a_ribbon_is_interpolated_between_its_stations() -> None:
    scene = bend()
    ribbon = ribbon_of(scene.roads[0], fitted(bounds(scene), 0.0, 0.0, 800.0))
    last = ribbon.stations[-1]
    for start, end in ((0.0, last), (0.3 * last, 0.7 * last), (last, last + 1e-3), (-5.0, 1.0)):
        part = ribbon.part(start, end)
        for whole, found in (
            (ribbon.center[:, 0], part.center[:, 0]),
            (ribbon.left[:, 1], part.left[:, 1]),
            (ribbon.half, part.half),
            (ribbon.borders[:, 0], part.borders[:, 0]),
            (ribbon.reference, part.reference),
        ):
            assert np.array_equal(found, np.interp(part.stations, ribbon.stations, whole))


def test_of_a_scene_of_nothing_a_hectare_around_the_origin_is_shown() -> None:
    nothing = replace(bend(), roads=(), agents=(), objects=())
    assert bounds(nothing) == BoundingBox(-50.0, -50.0, 50.0, 50.0)
