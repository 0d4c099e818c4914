"""Roads and randomness for kinds tested by themselves."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.api import BatchRandom, RoadBatch
from tests.standard.roads_of_points import road_of


@pytest.fixture(scope="session")
def straight() -> RoadBatch:
    return road_of([(0, 0), (100, 0), (200, 0)])


@pytest.fixture(scope="session")
def ring() -> RoadBatch:
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    return road_of([(60 * np.cos(a), 60 * np.sin(a)) for a in turn], closed=True)


@pytest.fixture
def random() -> BatchRandom:
    return BatchRandom(np.arange(1, 9, dtype=np.uint64))
