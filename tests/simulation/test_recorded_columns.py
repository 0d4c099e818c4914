"""The members of a recorded trace are computed when they are first read, and are the same for every
reader."""

from __future__ import annotations

import pickle
from dataclasses import fields
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import AgentTrace, Trace
from roadlang.drive.controllers import python_controllers
from roadlang.drive.simulators import simulator_of
from roadlang.plugins.discovery import load_registry
from roadlang.simulation.signals.recorded_columns import RecordedPart, _rate
from roadlang.simulation.signals.recorded_samples import RECORDED, RecordedSample

BEND = """
road main { draw with segments { pieces: [straight(20m), arc(20m, 90deg), straight(20m)] } }
agent ego is car on main at 5m { lane: -1, drive with lane_follow { speed: 8m/s } }
"""
ARRAYS = [one.name for one in fields(AgentTrace) if one.name not in ("name", "length", "width")]


def driven() -> AgentTrace:
    """The ego's trace of a short drive."""
    registry = load_registry()
    scene = testing.sample(BEND, 1)[0].record
    _, simulator = simulator_of(scene, registry, "builtin", {"duration": 2.0})
    trace: Trace = next(iter(simulator.drive_all([scene], [python_controllers(scene, registry)])))
    return trace.agents["ego"]


@pytest.mark.parametrize("first", ARRAYS)
def test_no_member_depends_on_which_is_read_first(first: str) -> None:
    usual, agent = driven(), driven()
    getattr(agent, first)
    for name in ARRAYS:
        np.testing.assert_array_equal(getattr(agent, name), getattr(usual, name))


def test_every_member_has_a_number_for_each_time() -> None:
    agent = driven()
    assert {name: getattr(agent, name).shape for name in ARRAYS} == dict.fromkeys(ARRAYS, (21,))


def test_times_are_written_with_their_decimals_alone() -> None:
    assert [float(time) for time in driven().time] == [number / 10 for number in range(21)]


def test_members_cannot_be_written_to() -> None:
    agent = driven()
    assert not any(getattr(agent, name).flags.writeable for name in ARRAYS)


def test_what_has_not_been_read_travels_to_other_processes() -> None:
    agent = driven()
    copied = pickle.loads(pickle.dumps(agent))
    for name in ARRAYS:
        np.testing.assert_array_equal(getattr(copied, name), getattr(agent, name))
    assert (copied.name, copied.length, copied.width) == ("ego", agent.length, agent.width)


def test_a_trace_has_no_other_members() -> None:
    with pytest.raises(AttributeError, match="`heigth`"):
        getattr(driven(), "heigth")  # noqa: B009 - mypy would find it


@pytest.mark.parametrize(
    ("values", "rate"),
    [
        ([], []),
        ([3.0], [0.0]),
        ([3.0, 5.0], [4.0, 4.0]),
        ([0.0, 1.0, 4.0], [2.0, 4.0, 6.0]),
        ([0.0, 1.0, 4.0, 0.0], [2.0, 4.0, -1.0, -8.0]),
    ],
)
def test_a_rate_is_of_the_samples_beside_and_nothing_of_one_alone(
    values: list[float], rate: list[float]
) -> None:
    found = _rate(np.array(values), np.arange(len(values), dtype=np.float64) / 2.0)
    assert found.tolist() == pytest.approx(rate)


class Unread:
    """Samples of two agents that know which of their quantities were looked at."""

    def __init__(self, seen: set[int]) -> None:
        self.seen = seen

    def __getitem__(self, place: int) -> np.ndarray:
        self.seen.add(place)
        return np.array([place, place + 0.5])


def test_quantities_that_nobody_reads_are_not_made_columns() -> None:
    """A search reads two or three of the sixteen of most drives."""
    seen: set[int] = set()
    rows: Any = Unread(seen)
    part = RecordedPart([RecordedSample(rows)] * 3, np.arange(2), lanes=None)  # type: ignore[arg-type]
    speed = RECORDED.index("speed")
    assert part.column(1, "speed").tolist() == [speed + 0.5] * 3
    assert seen == {speed}
