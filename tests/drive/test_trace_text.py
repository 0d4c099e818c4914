"""The text of traces, cell by cell."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.drive.trace_files import recorded_columns, to_csv
from roadlang.ir.trace import AgentTrace, Trace


@pytest.mark.parametrize("count", [0, 1, 2, 5])
def test_each_cell_of_a_table_has_nine_digits_or_is_empty(count: int) -> None:
    time = np.arange(count) / 10.0
    varying = np.array([-0.0, 1.0 / 3.0, 1e-7, 123456789.5, -2e30])[:count]
    gaps = np.where(np.arange(count) == 1, np.nan, varying)
    same = np.full(count, 0.125)
    unlimited = np.full(count, np.inf)
    agents = {
        name: AgentTrace(
            name, time, varying, gaps, same, unlimited, gaps[::-1], -same, varying * 3.0, same,
            unlimited, same, 4.5, 1.8,
        )
        for name in ("ego", "50 %, a")
    }  # fmt: skip
    trace = Trace(time, agents, "engine", ())
    header, *rows = to_csv(trace).splitlines()
    columns = recorded_columns(agents.values())
    assert header == ",".join(("time", "agent", *columns))

    def cell(value: float) -> str:
        return f"{value:.9g}" if np.isfinite(value) else ""

    assert rows == [
        ",".join(
            (cell(time[at]), shown, *(cell(getattr(agents[name], one)[at]) for one in columns))
        )
        for at in range(count)
        for name, shown in (("ego", "ego"), ("50 %, a", '"50 %, a"'))
    ]
