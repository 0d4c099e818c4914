"""Labels of agents that are close together."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roadlang_standard.svg.labels import PixelBox, actor_labels
from tests.backends.handmade_scenes import actor, bend
from tests.backends.svg_shapes import PAGE, written

FONT = 10.0


def test_a_label_is_nearest_to_what_it_names() -> None:
    """Numbers leave two places for the name of the second car: above, where it would be nearer to
    the first, and on the right, over the corner of the square around a bus."""
    cars = [actor(n, "car", 50, y, length=4.0) for n, y in (("one", 33), ("two", 25))]
    bus = actor("bus", "bus", 60, 21, length=12.0)
    taken = [
        PixelBox(400, 204, 600, 232),
        PixelBox(400, 270, 600, 285),
        PixelBox(400, 240, 499, 260),
    ]
    scene = replace(bend(), agents=(*cars, bus), objects=(), roads=())
    name, x, y = written(actor_labels(scene, PAGE, FONT, taken))[1]
    assert name == "two"
    assert (x, y) == pytest.approx((534.8, 253.5), abs=0.02)
