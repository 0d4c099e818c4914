"""Sensors that plugins bring: read by controllers, and named where they are at fault."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError
from roadlang.api import (
    ControlBatch,
    Controller,
    Length,
    ObservationBatch,
    ReadingArray,
    SensedBatch,
    Sensor,
    String,
    option,
)
from tests.simulation.sensed_drives import agent, record, runs


@dataclass(frozen=True)
class Odometer(Sensor):
    """Counts measurements and meters; may give something else."""

    name: ClassVar[str] = "odometer"
    fault: Length = option(0.0)

    def arrays(self) -> dict[str, ReadingArray]:
        return {"count": ReadingArray(dtype="int32"), "meters": ReadingArray(unit="m")}

    def start(self, count: int) -> Any:
        return np.zeros(count)

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, Any]:
        state += 1
        meters = sensed.seen.traveled
        return {"count": state, "meters": np.where(np.asarray(self.fault) > 0, np.nan, meters)}


@dataclass(frozen=True)
class Braking(Controller):
    """Brakes after 10 m by its odometer, for many agents at once."""

    name: ClassVar[str] = "braking"

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        meters = observations.sensors["wheel"].meters
        assert meters.shape == observations.x.shape
        return ControlBatch(np.full(len(meters), np.nan), np.where(meters > 10.0, -5.0, 0.0))


def test_sensors_of_plugins_are_read_by_controllers_of_plugins() -> None:
    body = "drive with braking\n sense with odometer as wheel { every: 200ms }"
    text = (
        agent(body)
        + "agent other is car on main at 60m { drive with braking\n sense with odometer as wheel }"
    )
    drives = runs(text, 2, kinds=(Odometer, Braking))
    for drive in drives:
        assert drive.trace.agents["ego"].speed[-1] == pytest.approx(0.0, abs=0.01)
        assert record(drive, "wheel").arrays["count"].tolist() == list(range(1, 21))


def test_a_sensor_that_gives_something_else_is_named() -> None:
    with pytest.raises(DiagnosticError, match=r"RL474.*sense tested.odometer.*`meters`"):
        runs(agent("sense with odometer { fault: 1m }"), kinds=(Odometer,))


@dataclass(frozen=True)
class Faulty(Sensor):
    """States or measures what no sensor can."""

    name: ClassVar[str] = "faulty"
    fault: String = option("")
    stated: ClassVar[dict[str, dict[Any, Any]]] = {
        "numbers": {"meters": 5},
        "names": {5: ReadingArray()},
        "archive": {"file": ReadingArray()},
        "shape": {"meters": ReadingArray(3)},  # type: ignore[arg-type]
        "size": {"meters": ReadingArray((-1,))},
        "type": {"meters": ReadingArray(dtype="furlong")},
        "text": {"meters": ReadingArray(dtype="U5")},
        "bytes": {"meters": ReadingArray(dtype="uint8")},
    }

    def arrays(self) -> dict[str, ReadingArray]:
        return self.stated.get(self.fault, {"meters": ReadingArray()})

    def start(self, count: int) -> Any:
        return np.array(0.0) if self.fault == "state" else None

    def readings(self, sensed: SensedBatch, state: Any) -> dict[str, Any]:
        return {"meters": sensed.seen.traveled + 300.0}


@dataclass(frozen=True)
class Replacing(Faulty):
    """Replaces what is no number for each agent."""

    name: ClassVar[str] = "replacing"
    replaces: ClassVar[tuple[str, ...]] = ("line_ahead", "x")

    def arrays(self) -> dict[str, ReadingArray]:
        return {"x": ReadingArray((2,)), **({"line_ahead": ReadingArray()} if self.fault else {})}


@pytest.mark.parametrize(
    ("sensor", "says"),
    [
        ("faulty { fault: numbers }", "`meters`, which is not a ReadingArray"),
        ("faulty { fault: names }", "an array 5; names have"),
        ("faulty { fault: archive }", "`file`; no array of a reading can be called so"),
        ("faulty { fault: shape }", "the shape 3 of its array `meters`"),
        ("faulty { fault: size }", r"the shape \(-1,\) of its array `meters`"),
        ("faulty { fault: type }", "the type 'furlong' of its array `meters`"),
        ("faulty { fault: text }", "the type 'U5' of its array `meters`"),
        ("faulty { fault: bytes }", "`meters` with values from 300.* which are no uint8"),
        ("faulty { fault: state }", "a state that is not an array of 1 rows"),
        ("replacing", "replaces `line_ahead`, which is not one of its arrays"),
        ("replacing { fault: column }", "`line_ahead`, which is not a column of numbers"),
    ],
)
def test_a_sensor_that_states_what_cannot_be_is_named(sensor: str, says: str) -> None:
    text = sensor.replace("fault: ", 'fault: "').replace(" }", '" }')
    with pytest.raises(DiagnosticError, match=rf"RL474.*sense tested.*{says}"):
        runs(agent(f"sense with {text}"), kinds=(Faulty, Replacing))
