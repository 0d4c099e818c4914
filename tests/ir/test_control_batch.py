"""What is decided one by one, as columns."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.ir.control import Control, ControlBatch

POSE = (1.0, 2.0, 0.5, 8.0)
NOWHERE = [math.nan] * 4


def test_columns_hold_what_each_says() -> None:
    batch = ControlBatch.of([Control(0.1, -2.0), Control(math.nan, 1.0, heading=0.3)])
    np.testing.assert_array_equal(batch.steering, [0.1, math.nan])
    np.testing.assert_array_equal(batch.acceleration, [-2.0, 1.0])
    assert batch.heading is not None
    np.testing.assert_array_equal(batch.heading, [math.nan, 0.3])
    assert batch.line_offset is batch.line_time is batch.pose is None


@pytest.mark.parametrize("moves_line", [False, True])
def test_who_has_no_pose_is_left_to_the_equations_of_motion(moves_line: bool) -> None:
    offset = 1.5 if moves_line else math.nan
    batch = ControlBatch.of([Control(0.0, 0.0, pose=POSE), Control(0.0, 0.0, line_offset=offset)])
    np.testing.assert_array_equal(batch.pose, [POSE, NOWHERE])
    assert (batch.line_offset is not None) is moves_line


def test_a_line_is_moved_for_those_alone_who_say_so() -> None:
    moving = Control(0.0, 0.0, line_offset=-1.0, line_time=3.0)
    batch = ControlBatch.of([moving, Control(0.0, 0.0)])
    np.testing.assert_array_equal(batch.line_offset, [-1.0, math.nan])
    np.testing.assert_array_equal(batch.line_time, [3.0, 0.0])
    assert batch.pose is None


@pytest.mark.parametrize(
    ("steering", "acceleration", "is_open"),
    [(0.1, 1.0, False), (math.nan, 1.0, True), (0.1, math.nan, True), (math.nan, math.nan, True)],
)
def test_what_is_open_is_filled_by_a_controller_before(
    steering: float, acceleration: float, is_open: bool
) -> None:
    control = Control(steering, acceleration, heading=0.2)
    assert control.is_open is is_open
    filled = control.filled(Control(0.5, -3.0, heading=9.0))
    assert filled.steering == (0.5 if math.isnan(steering) else steering)
    assert filled.acceleration == (-3.0 if math.isnan(acceleration) else acceleration)
    assert filled.heading == 0.2
