"""Lines beside a line, where this bends more tightly than they are away."""

from __future__ import annotations

import numpy as np

from roadlang.geometry import unfolded_lines


def test_a_line_that_does_not_turn_back_is_left_as_it_is() -> None:
    center = np.array([[0.0, 0.0], [10.0, 0.0], [20.0, 0.0]])
    assert len(unfolded_lines(center + np.array([0.0, 5.0]), center, 0.35)) == 1


def test_a_line_makes_no_loop_inside_a_tight_bend() -> None:
    """A quarter turn of 4 m radius between straights, and the line 10 m to its inside."""
    angle = np.linspace(0, np.pi / 2, 30)
    arc = np.column_stack([4 * np.sin(angle), 4 * (1 - np.cos(angle))])
    before, after = np.linspace([-30, 0], [-0.5, 0], 60), np.linspace([4, 4.5], [4, 34], 60)
    center = np.concatenate([before, arc, after])
    heading = np.concatenate([np.zeros(60), angle, np.full(60, np.pi / 2)])
    inner = center + 10 * np.column_stack([-np.sin(heading), np.cos(heading)])
    parts = unfolded_lines(inner, center, 0.35)
    assert len(parts) == 2
    assert min(np.hypot(*(point - center).T).min() for part in parts for point in part) > 9.6
