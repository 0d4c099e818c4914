"""Outlines of colored areas are no sure roads; a ring road on even ground is one."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang.api import Picture
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.doubts.outlines import sure_by_outlines
from roadlang_standard.extraction.networks.found_network import FoundRoad

_INNER, _OUTER = (60, 220, 255), (245, 245, 245)


def _ring(width: int, inner: tuple[int, int, int]) -> tuple[list[FoundRoad], np.ndarray]:
    """A dark circle around a color, and its middle."""
    picture = np.full((500, 500, 3), _OUTER, np.uint8)
    cv2.circle(picture, (250, 250), 180, inner, -1, cv2.LINE_AA)
    cv2.circle(picture, (250, 250), 180, (30, 60, 90), width, cv2.LINE_AA)
    angle = np.linspace(0, 2 * np.pi, 400)
    points = 250 + 180 * np.column_stack([np.cos(angle), np.sin(angle)])
    return [FoundRoad(0, 0, points, np.full(400, float(width)))], picture


def _sure(width: int, inner: tuple[int, int, int]) -> float:
    return sure_by_outlines(*_ring(width, inner))


def test_a_thin_ring_around_another_color_is_an_outline() -> None:
    assert _sure(6, _INNER) == 0.45
    assert _sure(6, _OUTER) == 1.0


def test_a_wide_ring_is_a_road_around_a_meadow() -> None:
    assert _sure(14, _INNER) == 1.0


def test_a_road_that_encloses_nothing_may_run_between_two_colors() -> None:
    (ring,), picture = _ring(6, _INNER)
    half = FoundRoad(0, 1, ring.points[:250], ring.widths[:250])
    assert sure_by_outlines([half], picture) == 1.0
    rest = FoundRoad(1, 0, ring.points[249:], ring.widths[249:])
    assert sure_by_outlines([half, rest], picture) == 0.45


@pytest.mark.parametrize("inner", [_INNER, _OUTER])
def test_the_outline_of_a_figure_is_no_sure_road(inner: tuple[int, int, int]) -> None:
    _, picture = _ring(8, inner)
    found = Auto().extract(Picture(picture, 1.0))
    (edge,) = found.network.edges
    assert (edge.confidence < 0.5) is (inner == _INNER)
