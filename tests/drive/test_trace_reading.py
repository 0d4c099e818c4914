"""Traces that another program wrote or someone edited are refused with what is wrong in them."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from roadlang.drive.trace_files import from_json, to_json
from roadlang.ir.trace import AgentTrace, Trace

COLUMNS = ("x", "y", "heading", "speed", "acceleration", "steering", "station",
           "cross_track_error", "progress", "contacts")  # fmt: skip


def document() -> Any:
    time = np.arange(3.0)
    columns: Any = dict.fromkeys(COLUMNS, time)
    ego = AgentTrace("ego", time, **columns)
    return json.loads(to_json(Trace(time, {"ego": ego}, "engine", ())))


def test_what_was_written_is_read() -> None:
    assert from_json(json.dumps(document())).agents["ego"].x.tolist() == [0.0, 1.0, 2.0]


@pytest.mark.parametrize("name", ["x", "speed", "lane"])
def test_a_column_of_another_length_is_named(name: str) -> None:
    changed = document()
    changed["agents"]["ego"][name] = [0.0, 1.0]
    with pytest.raises(ValueError, match=f"`{name}` of `ego` has 2 values for 3 times"):
        from_json(json.dumps(changed))


@pytest.mark.parametrize("size", [None, "4", -1.0, float("nan"), float("inf"), True, []])
def test_a_size_that_is_no_length_is_named(size: object) -> None:
    changed = document()
    changed["agents"]["ego"]["width"] = size
    with pytest.raises(ValueError, match="`width` of `ego` is a length in meters, not"):
        from_json(json.dumps(changed))


def test_an_event_that_is_no_map_is_refused() -> None:
    changed = document()
    changed["events"] = "x"
    with pytest.raises(ValueError, match="an event is a map, not 'x'"):
        from_json(json.dumps(changed))


def test_a_failure_of_a_controller_has_its_members() -> None:
    changed = document()
    changed["events"] = [{"event": "controller_failed", "time": 1.0, "agent": "ego"}]
    with pytest.raises(KeyError, match="reason"):
        from_json(json.dumps(changed))
