"""What controllers that decide now and then have decided holds until they decide again."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from roadlang.ir.control import ControlBatch
from roadlang.simulation.controlling.controller_groups import HELD, Group


def test_a_held_decision_keeps_the_line_that_it_moved_to() -> None:
    none = cast(Any, None)
    held = np.full((len(HELD), 2), np.nan)
    group = Group(0, none, np.arange(2), {}, None, [], np.full(2, -np.inf), held)
    offset, time = np.array([3.5]), np.array([2.0])
    agent = np.array([1])
    decided = ControlBatch(np.zeros(1), np.ones(1), line_offset=offset, line_time=time)
    group.hold(agent, decided, 0.0)
    later = group.last_decided(agent)
    assert later.line_offset is not None
    assert later.line_time is not None
    assert (later.line_offset[0], later.line_time[0], later.acceleration[0]) == (3.5, 2.0, 1.0)
    assert later.heading is None
