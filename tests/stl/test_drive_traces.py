"""The traces that `roadlang run` writes are read by `monitor`, `mine` and `read_trace`."""

from __future__ import annotations

import json
import math
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from roadlang import DiagnosticError, stl
from roadlang.cli.main import run
from roadlang.drive.trace_files import COLUMNS, to_csv, to_json
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.ir.trace_document import trace_schema


def agent(name: str, speed: float, contacts: float = 0.0) -> AgentTrace:
    time = np.array([0.0, 0.5, 1.0])
    values = {column: np.zeros(3) for column in COLUMNS}
    values |= {"speed": speed * time, "contacts": np.full(3, contacts)}
    return AgentTrace(name, time, **values)  # type: ignore[arg-type]


def trace(*agents: AgentTrace) -> Trace:
    return Trace(agents[0].time, {found.name: found for found in agents}, "test 1.0")


@pytest.fixture(params=["csv", "json"])
def files(request: pytest.FixtureRequest, tmp_path: Path) -> dict[str, str]:
    """A trace of one agent, and one of two, in either format."""
    found = {}
    one, two = trace(agent("ego", 8.0)), trace(agent("ego", 8.0, math.nan), agent("car[1]", 3.0))
    for name, drive in (("one", one), ("two", two)):
        path = tmp_path / f"{name}.{request.param}"
        path.write_text(to_csv(drive) if request.param == "csv" else to_json(drive))
        found[name] = str(path)
    return found


def test_the_signals_have_the_names_of_their_agents(files: dict[str, str]) -> None:
    axis, positions, signals = stl.read_trace(files["two"])
    assert (axis, positions) == ("time", [0.0, 0.5, 1.0])
    assert signals["ego.speed"] == [0.0, 4.0, 8.0]
    assert signals["car[1].speed"] == [0.0, 1.5, 3.0]
    assert "speed" not in signals
    assert all(math.isnan(value) for value in signals["ego.contacts"])


def test_those_of_one_agent_have_plain_names_too(files: dict[str, str]) -> None:
    assert stl.read_trace(files["one"])[2]["speed"] == [0.0, 4.0, 8.0]
    assert stl.read_trace(files["two"], agent="car[1]")[2]["speed"] == [0.0, 1.5, 3.0]


def test_an_agent_that_is_not_there_is_said(files: dict[str, str], tmp_path: Path) -> None:
    with pytest.raises(DiagnosticError, match=r"no agent `eggo`(.|\n)*did you mean `ego`"):
        stl.read_trace(files["two"], agent="eggo")
    other = tmp_path / "other.csv"
    other.write_text("t,x\n0,1\n")
    with pytest.raises(DiagnosticError, match="not the trace of a drive"):
        stl.read_trace(other, agent="ego")


def test_monitor_judges_them(files: dict[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["monitor", "always (ego.speed < 9m/s)", files["one"]]) == 0
    assert run(["monitor", "always (speed < 9m/s)", files["one"]]) == 0
    assert run(["monitor", "always (ego.speed < 7m/s)", files["two"]]) == 4
    assert run(["monitor", "always (speed < 7m/s)", files["two"], "--agent", "car[1]"]) == 0
    capsys.readouterr()
    assert run(["monitor", "always (speed < 7m/s)", files["two"]]) == 1
    assert "speed" in capsys.readouterr().err


def test_mine_finds_parameters_of_them(
    files: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["mine", "always (speed < top)", "--param", "top=0..20", files["two"]]
    assert run([*words, "--agent", "ego"]) == 0
    assert "top = 8" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("a.csv", "time,agent,speed\n0,ego,1,2\n", "line 2 has 4 cells, not 3"),
        ("a.json", '{"schema": "roadlang.trace/2"}', "no `time` or no `agents`"),
        ("a.json", '{"schema": "roadlang.trace/2", "time": [0], "agents": []}', "no `agents`"),
        (
            "a.json",
            '{"schema": "roadlang.trace/2", "time": [0], "agents": {"ego": {"x": [1, 2]}}}',
            "2 values for 1 positions",
        ),
    ],
)
def test_damaged_traces_are_refused(name: str, text: str, problem: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(DiagnosticError, match=f"RL340(.|\n)*{problem}"):
        stl.read_trace(tmp_path / name)


def test_an_agent_without_a_row_at_some_time_has_a_gap(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text("time,agent,speed\n0,ego,1\n0,late,\n1,ego,2\n1,late,5\n2,ego,3\n")
    signals = stl.read_trace(path)[2]
    assert signals["ego.speed"] == [1.0, 2.0, 3.0]
    assert math.isnan(signals["late.speed"][0])
    assert signals["late.speed"][1] == 5.0
    assert math.isnan(signals["late.speed"][2])


def test_traces_fit_their_schema() -> None:
    schema = trace_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    document = json.loads(to_json(trace(agent("ego", 8.0, math.nan))))
    jsonschema.validate(document, schema)
    columns = schema["$defs"]["AgentColumns"]
    assert set(columns["properties"]) == {*COLUMNS, "elevation", "length", "width"}
    assert {"x", "y", "speed", "contacts"} <= set(columns["required"])
    del document["agents"]["ego"]["x"]
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(document, schema)
