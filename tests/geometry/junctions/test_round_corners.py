"""Corners of junctions are drawn with chords that stay close to their curve."""

from __future__ import annotations

import numpy as np
import pytest

from tests.geometry.junctions.crossings_of_roads import only, plan_of, star


@pytest.mark.parametrize("width", [5.0, 7.0, 14.0])
@pytest.mark.parametrize("degrees", [(0, 90, 180, 270), (0, 70, 200), (0, 120, 240)])
def test_chords_of_round_corners_are_within_1_cm_of_them(
    degrees: tuple[float, ...], width: float
) -> None:
    ring = np.array(only(plan_of(star(*degrees, width=width))).area)
    step = np.roll(ring, -1, axis=0) - ring
    heading = np.arctan2(step[:, 1], step[:, 0])
    turn = np.abs(np.angle(np.exp(1j * (heading - np.roll(heading, 1)))))
    is_round = (turn < np.radians(20.0)) & (np.roll(turn, -1) < np.radians(20.0))
    away = np.hypot(*step.T) * np.tan(turn / 4.0) / 2.0
    assert is_round.sum() >= 6 * len(degrees)
    assert away[is_round].max() < 0.0115
