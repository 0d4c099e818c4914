"""Traces as files: CSV for spreadsheets and plots, JSON with everything."""

from __future__ import annotations

import csv
import io
import json
import math
from typing import TYPE_CHECKING, Any

from ..ir.trace import AgentTrace, Trace
from ..ir.trace_document import TRACE_SCHEMA

if TYPE_CHECKING:
    import numpy as np

_FIRST_SCHEMA = "roadlang.trace/1"
"""The first version has `cross_track` for `cross_track_error`; it is still read."""
ADDED_COLUMNS = (
    "road", "lane", "lane_offset", "route_progress", "speed_limit", "off_road", "red_light",
    "collision",
)  # fmt: skip
"""Older files lack them."""
COLUMNS = (
    "x", "y", "heading", "speed", "acceleration", "steering", "station", "cross_track_error",
    "progress", "contacts", *ADDED_COLUMNS,
)  # fmt: skip


def to_csv(trace: Trace) -> str:
    """One row for each agent at each time; SI units and radians, 9 significant digits."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(("time", "agent", *COLUMNS))
    for index, time in enumerate(trace.time):
        for name, agent in trace.agents.items():
            row = (_shown(getattr(agent, column)[index]) for column in COLUMNS)
            writer.writerow((_shown(time), name, *row))
    return out.getvalue()


def to_json(trace: Trace) -> str:
    """Columns by agent; what an engine does not report is null."""
    agents = {name: _columns(agent) for name, agent in trace.agents.items()}
    document = {
        "schema": TRACE_SCHEMA,
        "engine": trace.engine,
        "time": _numbers(trace.time),
        "agents": agents,
        "events": [dict(event) for event in trace.events],
    }
    return json.dumps(document, allow_nan=False, separators=(",", ":")) + "\n"


def from_json(text: str) -> Trace:
    """The trace in a document that `to_json` wrote. Raises `ValueError` for any other."""
    import numpy as np

    document = json.loads(text)
    if document.get("schema") not in (TRACE_SCHEMA, _FIRST_SCHEMA):
        raise ValueError(f"not a trace: schema {document.get('schema')!r}")
    time = np.array(document["time"], dtype=float)
    agents = {
        name: AgentTrace(
            name=name,
            time=time,
            length=values["length"],
            width=values["width"],
            **_read(values),
        )
        for name, values in document["agents"].items()
    }
    return Trace(time, agents, document["engine"], tuple(document["events"]))


def _read(values: dict[str, Any]) -> dict[str, np.ndarray[Any, Any]]:
    import numpy as np

    columns = {
        name: np.array(_column(values, name), dtype=float)
        for name in COLUMNS
        if name in values or name not in ADDED_COLUMNS
    }
    if "speed_limit" in columns:  # infinity is no JSON: where the road is known, null is no limit
        limit = columns["speed_limit"]
        columns["speed_limit"] = np.where(
            np.isnan(limit) & ~np.isnan(columns["road"]), np.inf, limit
        )
    return columns


def _column(values: dict[str, Any], name: str) -> list[float | None]:
    key = name if name in values else name.removesuffix("_error")
    column: list[float | None] = values[key]
    return column


def _columns(agent: AgentTrace) -> dict[str, Any]:
    columns: dict[str, Any] = {name: _numbers(getattr(agent, name)) for name in COLUMNS}
    return {**columns, "length": agent.length, "width": agent.width}


def _numbers(values: np.ndarray[Any, Any]) -> list[float | None]:
    return [value if math.isfinite(value) else None for value in values.tolist()]


def _shown(value: float) -> str:
    return f"{float(value):.9g}" if math.isfinite(value) else ""
