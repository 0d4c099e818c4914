"""Sideways moves of lines: quintics, with the peaks that physics by hand gives."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry.arrays import Floats
from roadlang.simulation.lines.lateral_motion import LateralMotion

STEP = 0.01


def moved(moves: LateralMotion, seconds: float, speed: float = 20.0) -> Floats:
    """Offsets of the only line at each step."""
    out = []
    for _ in range(round(seconds / STEP)):
        moves.advance(np.array([speed]), STEP)
        out.append(float(moves.offset[0]))
    return np.array(out)


@pytest.mark.parametrize("height", [3.5, -3.25])
@pytest.mark.parametrize("time", [2.5, 4.0])
def test_a_move_has_the_peaks_of_its_quintic(height: float, time: float) -> None:
    moves = LateralMotion.at_rest(np.array([1.0]))
    moves.move(np.array([1.0 + height]), np.array([time]))
    offset = moved(moves, time + 1.0)
    speed = np.gradient(offset, STEP)
    acceleration = np.gradient(speed, STEP)
    assert np.abs(speed).max() == pytest.approx(1.875 * abs(height) / time, rel=1e-3)
    assert np.abs(acceleration).max() == pytest.approx(5.774 * abs(height) / time**2, rel=5e-3)
    assert offset[-1] == 1.0 + height
    between = np.sign(height) * np.diff(offset)
    assert between.min() > -1e-12  # it never overshoots


def test_a_move_that_is_called_off_begins_anew_from_where_it_is() -> None:
    moves = LateralMotion.at_rest(np.array([0.0]))
    moves.move(np.array([3.5]), np.array([4.0]))
    first = moved(moves, 1.5)
    moves.move(np.array([0.0]), np.array([4.0]))
    second = moved(moves, 4.5)
    offset = np.concatenate([first, second])
    speed = np.diff(offset) / STEP
    assert np.abs(np.diff(speed)).max() / STEP < 2.0  # m/s^2: no kink where it turns back
    assert np.abs(np.diff(speed, 2)).max() / STEP**2 < 30.0  # m/s^3, nor a jump of acceleration
    assert offset[-1] == 0.0
    assert offset.max() > first[-1]  # it goes on a little, as a car would


def test_the_same_target_again_goes_on_with_the_move() -> None:
    once, again = (LateralMotion.at_rest(np.array([0.0])) for _ in range(2))
    once.move(np.array([3.5]), np.array([4.0]))
    for _ in range(600):
        again.move(np.array([3.5]), np.array([4.0]))
        for line in (once, again):
            line.advance(np.array([20.0]), STEP)
    assert once.offset == again.offset == 3.5


def test_the_line_waits_for_an_agent_that_stands() -> None:
    moves = LateralMotion.at_rest(np.array([0.0]))
    moves.move(np.array([3.5]), np.array([4.0]))
    assert moved(moves, 2.0)[-1] == pytest.approx(1.75)
    assert moved(moves, 10.0, speed=0.0)[-1] == pytest.approx(1.75)
    assert moved(moves, 2.1)[-1] == 3.5


def test_without_a_time_the_line_is_there_at_once() -> None:
    moves = LateralMotion.at_rest(np.array([0.0, 1.0, 2.0]))
    moves.move(np.array([3.0, np.nan, 5.0]), None)
    assert moves.offset.tolist() == [3.0, 1.0, 5.0]


def test_the_line_ahead_is_where_it_will_be() -> None:
    moves = LateralMotion.at_rest(np.array([0.0]))
    moves.move(np.array([3.5]), np.array([4.0]))
    moved(moves, 1.0)
    offset, slope, bend, _ = moves.ahead(slice(None), 20.0, np.array([20.0]))
    later = moved(moves, 1.0)
    assert offset[0] == pytest.approx(later[-1])
    assert slope[0] == pytest.approx(1.875 * 3.5 / 4 / 20.0, rel=1e-3)  # midway: the peak
    assert bend[0] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("time", [2.0, 5.0])
def test_a_move_in_another_time_begins_with_the_speed_of_the_one_before(time: float) -> None:
    moves = LateralMotion.at_rest(np.array([0.0]))
    moves.move(np.array([3.5]), np.array([4.0]))
    first = moved(moves, 1.5)
    moves.move(np.array([4.5]), np.array([time]))
    second = moved(moves, 0.2)
    speed = np.diff(np.concatenate([first, second])) / STEP
    begins = len(first) - 1
    assert speed[begins] == pytest.approx(speed[begins - 1], abs=0.02)
    acceleration = np.diff(speed) / STEP
    assert acceleration[begins] == pytest.approx(acceleration[begins - 2], abs=0.2)
