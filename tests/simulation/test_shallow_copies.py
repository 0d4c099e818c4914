"""Copies between two decisions share what they hold, and nothing that is replaced."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roadlang.geometry.arrays import Floats
from roadlang.simulation.shallow_copies import shallow


@dataclass
class Pair:
    speed: Floats
    time: float = 0.0


def test_a_copy_has_the_same_members_until_one_is_replaced() -> None:
    pair = Pair(np.zeros(3), 2.0)
    other = shallow(pair)
    assert type(other) is Pair
    assert other.speed is pair.speed
    other.time = 3.0
    other.speed = np.ones(3)
    assert pair.time == 2.0
    assert pair.speed.tolist() == [0.0, 0.0, 0.0]
