"""Center lines of many roads, whose headings are looked at together."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roadlang.simulation.lines.line_nodes import Spacing, line_nodes
from roadlang.simulation.lines.line_sources import LineSource, straight_line, without_jumps


def line(*heading: float) -> LineSource:
    one = straight_line(0.0, 0.0, 0.0)
    s = np.arange(len(heading), dtype=np.float64)
    return replace(one, s=s, x=s, y=s, heading=np.array(heading))


def test_a_heading_that_jumps_by_a_turn_goes_on() -> None:
    smooth, jumps = line(0.0, 0.1), line(3.0, 3.1, -3.1, -3.0)
    found = without_jumps([smooth, jumps, smooth])
    assert found[0] is smooth
    assert found[2] is smooth
    assert found[1].heading.tolist() == np.unwrap(jumps.heading).tolist()
    assert found[1].s is jumps.s


def test_from_one_line_to_the_next_headings_may_jump() -> None:
    lines = [line(3.0, 3.1), line(-3.1, -3.0), line(3.1)]
    assert all(one is other for one, other in zip(without_jumps(lines), lines, strict=True))


def test_headings_are_looked_at_wherever_a_line_stands_among_many() -> None:
    smooth, jumps = line(0.0, 0.1), line(3.0, 3.1, -3.1, -3.0)
    lines = [jumps if number in (0, 63, 64, 150) else smooth for number in range(151)]
    found = without_jumps(lines)
    changed = [number for number, one in enumerate(found) if one is not lines[number]]
    assert changed == [0, 63, 64, 150]
    assert all(np.abs(np.diff(found[number].heading)).max() < 1.0 for number in changed)


def test_nodes_beyond_both_ends_lie_straight_on() -> None:
    """Motion needs one on either side of each place."""
    ends = np.array([0.0, 6.0])
    source = LineSource(ends, 2.0 + ends, np.full(2, 7.0), np.zeros(2), 3.5)
    spacing = Spacing.of([source], 0.0)
    x, y = line_nodes([source], spacing, spacing.nodes)[:2, 0]
    assert x.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
    assert (y == 7.0).all()
