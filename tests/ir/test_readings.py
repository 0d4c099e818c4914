"""Readings of sensors: named arrays, of one agent or of a batch."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from roadlang.ir.readings import Reading, Readings, batch_of_one

BATCH = Reading(
    np.array([0.5, 0.75]),
    {"distances": np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]), "count": np.array([7, 8])},
)


def test_arrays_are_members_and_items() -> None:
    assert BATCH.distances is BATCH["distances"]
    assert list(BATCH) == ["distances", "count"]
    assert len(BATCH) == 2


def test_the_error_for_another_array_names_those_there_are() -> None:
    with pytest.raises(AttributeError, match="no array `range`; it has distances, count"):
        _ = BATCH.range
    with pytest.raises(AttributeError, match="no array `_hidden`"):
        _ = BATCH._hidden


def test_of_one_agent_what_has_no_axis_is_a_number() -> None:
    second = BATCH.single(1)
    assert (second.time, second["count"]) == (0.75, 8)
    assert (type(second.time), type(second["count"])) == (float, int)
    assert second.distances.tolist() == [4.0, 5.0, 6.0]


def test_a_reading_as_a_batch_and_back_is_the_same() -> None:
    batch = batch_of_one(BATCH.single(0))
    assert batch.time.tolist() == [0.5]
    assert batch.distances.tolist() == [[1.0, 2.0, 3.0]]
    assert batch["count"].tolist() == [7]
    assert batch.single(0)["count"] == 7


def test_a_reading_can_be_sent_to_another_process() -> None:
    sent = pickle.loads(pickle.dumps(BATCH.single(1)))
    assert (sent.time, sent["count"], sent.distances.tolist()) == (0.75, 8, [4.0, 5.0, 6.0])


def test_the_error_for_another_sensor_names_those_the_agent_has() -> None:
    readings = Readings({"lidar": BATCH, "gps": BATCH})
    assert readings["gps"] is BATCH
    assert (list(readings), len(readings)) == (["lidar", "gps"], 2)
    with pytest.raises(KeyError, match="no sensor `radar`; the agent has lidar, gps"):
        readings["radar"]
    with pytest.raises(KeyError, match="the agent has none"):
        Readings({})["radar"]
