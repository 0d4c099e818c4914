"""Quantities that follow from others are not recorded in repeated steps: they are computed when
they are read, to the same bytes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from roadlang.api import Scene
from roadlang.simulation.recording.recording import Recorder
from roadlang.simulation.signals.derived_columns import KEPT
from roadlang.simulation.signals.recorded_samples import RecordedSample, column_of, taken
from roadlang.simulation.tapes.repeating import Repetition

from .test_repeated_steps import BENT, ON_A_LOOP, STANLEY
from .test_same_bytes import bytes_of, drives, records

AGAINST = BENT.replace("lane: -1", "lane: 1").replace("DRIVER", "stanley { speed: 15m/s }")


def step_by_step(
    scenes: Sequence[Scene], monkeypatch: pytest.MonkeyPatch, **options: Any
) -> list[dict[str, bytes]]:
    """The drives without any repeated steps."""
    with monkeypatch.context() as without:
        without.setattr(Repetition, "of", lambda *_: None)
        return [bytes_of(trace) for trace in drives(scenes, **options)]


@pytest.mark.parametrize(
    ("text", "options"),
    [
        (STANLEY, {"control_step": 0.1}),
        (STANLEY, {"control_step": 0.1, "after_violation": 1.0}),
        (AGAINST, {"control_step": 0.04}),
        (ON_A_LOOP, {"control_step": 0.04}),
    ],
    ids=["to_the_end", "ends_early", "against", "loop"],
)
def test_traces_are_those_of_single_steps(
    text: str, options: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    scenes = records(text, 4)
    found = [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)]
    assert found == step_by_step(scenes, monkeypatch, duration=20.0, **options)


def test_repeated_steps_record_no_more_than_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    recorded: list[float] = []
    samples: list[RecordedSample] = []
    record, add_all = Recorder.record, Recorder.add_all

    def note(self: Recorder, world: Any, poses: Any) -> None:
        recorded.append(world.time)
        record(self, world, poses)

    def note_all(self: Recorder, times: Any, found: Any, finished: Any) -> None:
        samples.extend(found)
        add_all(self, times, found, finished)

    monkeypatch.setattr(Recorder, "record", note)
    monkeypatch.setattr(Recorder, "add_all", note_all)
    (trace,) = drives(records(STANLEY, 1), duration=5.0)
    assert recorded == [0.0], "all others are on the tape"
    assert len(samples) == len(trace.time) - 1
    assert {len(sample.rows) for sample in samples} == {len(KEPT)}


def test_samples_of_some_agents(monkeypatch: pytest.MonkeyPatch) -> None:
    samples: list[RecordedSample] = []
    add_all = Recorder.add_all

    def note_all(self: Recorder, times: Any, found: Any, finished: Any) -> None:
        samples.extend(found)
        add_all(self, times, found, finished)

    monkeypatch.setattr(Recorder, "add_all", note_all)
    drives(records(STANLEY, 3), duration=2.0)
    agents = np.array([2, 0])
    for name in ("station", "cross_track_error", "progress", "contacts", "speed"):
        some = column_of(taken(samples, agents), name)
        assert some.tobytes() == column_of(samples, name, agents).tobytes()
        assert some.tobytes() == column_of(samples, name)[:, agents].tobytes()
