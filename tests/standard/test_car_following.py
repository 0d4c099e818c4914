"""The model by which cars keep their distance, against its formulas: M. Treiber and A. Kesting,
Traffic Flow Dynamics (2013), sections 11.3.7 and 11.3.8."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest

from roadlang.api import STANDING_GAP
from roadlang_standard.drive_traffic import Following

MOST, BRAKING, HEADWAY, TARGET = 1.7, 2.3, 1.2, 12.0
SPEEDS = (0.0, 0.05, 3.0, 11.0, 12.0, 13.0, 30.0)


def model(speeds: tuple[float, ...], **changed: float) -> Following:
    speed = np.array(speeds)
    most, braking = np.full(len(speed), MOST), np.full(len(speed), BRAKING)
    target = np.full(len(speed), changed.get("target", TARGET))
    return Following(speed, target, most, braking, HEADWAY)


def free(speed: float) -> float:
    if speed <= TARGET:
        return MOST * (1.0 - (max(speed, 0.1) / TARGET) ** 4)
    return float(-BRAKING * (1.0 - (TARGET / speed) ** (4.0 * MOST / BRAKING)))


def behind(speed: float, gap: float, ahead: float) -> float:
    closing = speed * (speed - ahead) / (2.0 * math.sqrt(MOST * BRAKING))
    need = (STANDING_GAP + max(0.0, HEADWAY * speed + closing)) / max(gap, 0.1)
    alone = free(speed)
    if need >= 1.0:
        close = MOST * (1.0 - need**2)
        return close + (alone if speed > TARGET else 0.0)
    return float(alone * (1.0 - need ** (2.0 * MOST / alone)) if alone > 0.0 else alone)


def test_a_free_road_lets_cars_reach_their_target() -> None:
    np.testing.assert_allclose(model(SPEEDS).free, [free(v) for v in SPEEDS], rtol=1e-12)


@pytest.mark.parametrize(
    ("gap", "ahead"), [*product((0.0, 2.5, 8.0, 40.0, 300.0), (0.0, 5.0, 20.0))]
)
def test_cars_keep_the_gap_of_the_model(gap: float, ahead: float) -> None:
    count = len(SPEEDS)
    found = model(SPEEDS).behind(np.full(count, gap), np.full(count, ahead))
    np.testing.assert_allclose(found, [behind(v, gap, ahead) for v in SPEEDS], atol=2e-3)


@pytest.mark.parametrize("distance", [-1.0, 0.0, 5.0, 10.0, 20.0, 30.0, 40.0, 100.0])
def test_a_stop_takes_at_least_the_even_deceleration_once_that_is_near_comfort(
    distance: float,
) -> None:
    gentle = [behind(v, distance + STANDING_GAP, 0.0) for v in SPEEDS]
    even = [0.5 * v * v / max(distance, 0.05) for v in SPEEDS]
    late = [e > 0.7 * BRAKING or distance < 0.0 for e in even]
    expected = [
        min(easy, -hard) if soon else easy
        for easy, hard, soon in zip(gentle, even, late, strict=True)
    ]
    found = model(SPEEDS).to_stop(np.full(len(SPEEDS), distance), np.array(gentle))
    np.testing.assert_allclose(found, expected, atol=2e-3)


def needed(speed: float, gap: float, ahead: float, leading: float) -> float:
    """Deceleration without a contact if the vehicle ahead keeps its acceleration (11.24)."""
    leading, gap = min(leading, MOST), max(gap, 0.1)
    if ahead * (speed - ahead) < -2.0 * gap * leading:
        return speed**2 * leading / (ahead**2 - 2.0 * gap * leading)
    return leading - (speed - ahead) ** 2 * (speed > ahead) / (2.0 * gap)


def calm(speed: float, gap: float, ahead: float, leading: float) -> float:
    """Equation 11.26 with a coolness factor of 0.99; who is too fast brakes as it would alone."""
    found, least = behind(speed, gap, ahead), needed(speed, gap, ahead, leading)
    if found >= least:
        return found
    calmed = 0.01 * found + 0.99 * (least + BRAKING * math.tanh((found - least) / BRAKING))
    return min(calmed, free(speed))


@pytest.mark.parametrize(
    ("gap", "ahead", "leading"),
    [*product((0.0, 2.5, 8.0, 40.0), (0.0, 5.0, 20.0), (-8.0, -1.0, 0.0, 1.0, 3.0))],
)
def test_cars_trust_that_who_is_ahead_keeps_its_acceleration(
    gap: float, ahead: float, leading: float
) -> None:
    gaps, paces, pulls = (np.full(len(SPEEDS), value) for value in (gap, ahead, leading))
    follow = model(SPEEDS)
    found = follow.calmly(follow.behind(gaps, paces), gaps, paces, pulls)
    expected = [calm(v, gap, ahead, leading) for v in SPEEDS]
    np.testing.assert_allclose(found, expected, atol=2e-3, rtol=1e-6)


@pytest.mark.parametrize("leading", [-5.0, 0.0, 2.0])
def test_with_nobody_ahead_nothing_changes(leading: float) -> None:
    follow, nobody = model(SPEEDS), np.full(len(SPEEDS), np.inf)
    zero = np.zeros(len(SPEEDS))
    found = follow.calmly(follow.free, nobody, zero, zero + leading)
    np.testing.assert_array_equal(found, follow.free)
