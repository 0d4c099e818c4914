"""Room among others, of what is alone: where it stands need not be found for that."""

from __future__ import annotations

import numpy as np
import pytest

import roadlang
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.evaluate.draw_record import DrawRecord
from roadlang.evaluate.indexed_scenario import IndexedScenario
from roadlang.world.index import index_scenario
from roadlang.world.placement.placement import room_among_others
from tests.straight_road import STRAIGHT

ONE = "agent ego is car on main at 20m { drive with stanley { speed: 10m/s } }\n"
TWO = ONE + "agent other is car on main at 21m..22m\n"
DRAWN = "agent ego is car on main at 20m..40m { drive with stanley { speed: 10m/s } }\n"


def of_text(text: str) -> IndexedScenario:
    loaded = roadlang.loads(STRAIGHT + text)
    return index_scenario(loaded.scenario, loaded.registry)


def candidates(scenario: IndexedScenario, record: DrawRecord | None = None) -> CandidateBatch:
    return CandidateBatch(scenario, 0, np.zeros(3, np.int64), np.arange(3), record=record)


@pytest.mark.parametrize(
    ("text", "name", "is_found"),
    [(ONE, "ego", False), (TWO, "ego", False), (TWO, "other", True), (DRAWN, "ego", True)],
)
def test_the_room_is_the_same_whether_places_are_found_for_it_or_not(
    text: str, name: str, is_found: bool
) -> None:
    scenario = of_text(text)
    batch, recorded = candidates(scenario), candidates(scenario, DrawRecord())
    actor = scenario.actors[name]
    room = room_among_others(actor, batch)
    assert room.tobytes() == room_among_others(actor, recorded).tobytes()
    assert (("placed", name) in batch._computed) == is_found
    assert ("placed", name) in recorded._computed
    assert (room < 0.0).all() == (name == "other")
