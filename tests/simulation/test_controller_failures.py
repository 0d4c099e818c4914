"""Controllers that fail while the drive goes on: in the trace, in tables, and on the page."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.api import Control, ControlBatch, Controller, Observation, ObservationBatch
from roadlang.drive.trace_files import from_json
from roadlang.falsification.outcome import Outcome
from roadlang.falsification.outcome_rows import row_of
from roadlang.ir.controller_failure import ControllerFailure
from roadlang.ir.trace import Trace
from roadlang.report.drive_records import drive_record, view
from roadlang.report.results import ShownDrive
from roadlang.session.finished_drives import record_of
from roadlang.session.scene import installed

from ..straight_road import STRAIGHT

REASON = "it stopped; it wrote:\n  Traceback\n  ValueError: too fast"


@dataclass(frozen=True)
class Fragile(Controller):
    """Fails at the first step from 1 s on."""

    name: ClassVar[str] = "fragile"
    interval: ClassVar[float] = 0.1

    def start(self, count: int) -> Any:
        return np.zeros(count, dtype=bool)

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        late = (np.asarray(observations.time) > 0.99) & (observations.agent != "sturdy")
        failures = {int(row): REASON for row in np.flatnonzero(late & ~state)}
        state[late] = True
        return ControlBatch(np.zeros(len(state)), np.zeros(len(state)), failures=failures)


class Prompt(Fragile):
    """The same, asked at every step."""

    name: ClassVar[str] = "prompt"
    interval: ClassVar[float] = 0.0


@dataclass(frozen=True)
class Single(Controller):
    """Decides for one agent, and fails at every step."""

    name: ClassVar[str] = "single"

    def control(self, observation: Observation) -> Control:
        return Control(0.0, 0.0, failure="no map" if 0.5 < observation.time < 0.55 else "")


def traced(kind: type[Controller], n: int = 1) -> Any:
    agents = "".join(
        f"agent {name} is car on main at {at}m {{ lane: -1, drive with {kind.name} }}\n"
        for name, at in (("sturdy", 20), ("ego", 60), ("other", 100))
    )
    text = STRAIGHT.replace("width", "lanes: 2, width") + agents
    text += "expect stays: always (ego.speed < 1m/s)\n"
    return testing.sample(text, n, kinds=[kind]).run("builtin", duration=2.0)


@pytest.mark.parametrize("kind", [Fragile, Prompt])
def test_a_controller_that_fails_is_an_event_of_its_agent(kind: type[Controller]) -> None:
    for drive in traced(kind, 2):
        failures = drive.trace.controller_failures
        assert [(each.agent, each.reason) for each in failures] == [
            ("ego", REASON), ("other", REASON),
        ]  # fmt: skip
        assert all(each.time == pytest.approx(1.0, abs=0.13) for each in failures)
        assert from_json(drive.to_json()).controller_failures == failures


def test_one_that_decides_alone_says_so_too() -> None:
    (failure, *_) = traced(Single)[0].trace.controller_failures
    assert (failure.agent, failure.reason) == ("ego", "no map")


@dataclass(frozen=True)
class Wrong(Controller):
    """Names an agent that is not in the batch."""

    name: ClassVar[str] = "wrong"

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        zero = np.zeros(len(observations.x))
        return ControlBatch(zero, zero, failures={3: "late"})


def test_who_is_not_in_the_batch_cannot_fail() -> None:
    with pytest.raises(roadlang.DiagnosticError, match=r"RL474.*\n?.*failures"):
        traced(Wrong)


def test_tables_have_the_first_failure_in_one_line_and_verdicts_have_all() -> None:
    drives = traced(Prompt)
    summary = "it stopped; it wrote: ValueError: too fast"
    (row,) = drives.rows()
    assert row["verdict"] == "holds"
    time = drives[0].trace.controller_failures[0].time
    columns = {
        "controller failure time": time,
        "controller failure agent": "ego",
        "controller failure reason": summary,
    }
    assert {name: row[name] for name in columns} == columns
    failures = record_of(drives[0])["controller_failures"]
    assert [each["agent"] for each in failures] == ["ego", "other"]
    outcome = Outcome(0, (), False, None, controller_failures=drives[0].trace.controller_failures)
    assert columns.items() <= row_of(outcome, [], ()).items()


@pytest.mark.parametrize(
    ("reason", "summary"),
    [
        ("it ended", "it ended"),
        ("it ended:\n\nf.js:9\nError: no\n    at x\nNode.js v20", "it ended: Error: no"),
        ("it ended:\nTraceback\n  a()\npkg.SpeedError: 13", "it ended: pkg.SpeedError: 13"),
        ("it ended:\nthread 'main' panicked at a\nnote", "it ended: thread 'main' panicked at a"),
        ("it ended:\nsome words\nSegmentation fault", "it ended: Segmentation fault"),
    ],
)  # fmt: skip
def test_the_summary_names_the_error(reason: str, summary: str) -> None:
    assert ControllerFailure("ego", 1.0, reason).summary == summary


def test_failures_in_which_a_controller_failed_are_of_another_cause() -> None:
    plain = Outcome(0, (), False, None, violated=("stays",))
    failure = ControllerFailure("ego", 1.0, "late")
    assert plain.cause != replace(plain, controller_failures=(failure,)).cause


def test_the_page_says_which_controllers_failed() -> None:
    drive = traced(Prompt)[0]
    trace: Trace = drive.trace
    verdicts = tuple(drive.verdicts.values())
    shown = ShownDrive("one", "1", 0, drive.scene.record, trace, verdicts, False)
    record = drive_record(view(shown, installed()), {}, 20)
    assert record["controllerFailures"] == [
        [each.agent, each.time, each.reason] for each in trace.controller_failures
    ]
