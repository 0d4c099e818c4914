"""What a human wanted who drove is kept to the last bit, one file for each agent."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roadlang import testing
from roadlang.drive.input_files import input_files


def test_each_agent_has_a_table_of_its_inputs() -> None:
    rows = np.array([[0.0, 0.1, -2.0], [0.02, 1.0 / 3.0, 1e-9]])
    trace = replace(
        testing.trace(testing.agent_trace(time=[0.0])), inputs={"ego": rows, "cars/2": rows[:0]}
    )
    found = input_files(trace)
    assert found == {
        "ego.inputs.csv": "time,steering,acceleration\n"
        "0.0,0.1,-2.0\n0.02,0.3333333333333333,1e-09\n",
        "cars-2.inputs.csv": "time,steering,acceleration\n",
    }
    lines = found["ego.inputs.csv"].splitlines()[1:]
    assert [[float(number) for number in line.split(",")] for line in lines] == rows.tolist()


def test_a_drive_without_a_human_has_none() -> None:
    assert input_files(testing.trace(testing.agent_trace(time=[0.0]))) == {}
