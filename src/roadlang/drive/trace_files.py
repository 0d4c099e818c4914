"""Traces as files: CSV for spreadsheets and plots, JSON with everything."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Iterable, Sequence
from itertools import chain
from typing import TYPE_CHECKING, Any

from ..ir.controller_failure import controller_failures
from ..ir.number_text import floats_text
from ..ir.trace import AgentTrace, Trace
from ..ir.trace_document import TRACE_SCHEMA

if TYPE_CHECKING:
    import numpy as np

_TIGHT = (",", ":")
_FORMAT = "%.9g"
_FIRST_SCHEMA = "roadlang.trace/1"
"""The first version has `cross_track` for `cross_track_error`; it is still read."""
ADDED_COLUMNS = (
    "road", "lane", "lane_offset", "route_progress", "speed_limit", "off_road", "red_light",
    "collision", "present",
)  # fmt: skip
"""Older files lack them."""
_ELEVATION = ("elevation",)
COLUMNS = (
    "x", "y", "heading", "speed", "acceleration", "steering", "station", "cross_track_error",
    "progress", "contacts", *ADDED_COLUMNS,
)  # fmt: skip


def recorded_columns(agents: Iterable[AgentTrace]) -> tuple[str, ...]:
    """Those of `COLUMNS`, and of scenes with roads on several levels the `elevation`."""
    import numpy as np

    has_elevation = any(np.isfinite(agent.elevation).any() for agent in agents)
    return (*COLUMNS, *_ELEVATION) if has_elevation else COLUMNS


def to_csv(trace: Trace) -> str:
    """One row for each agent at each time; SI units and radians, 9 significant digits."""
    names = recorded_columns(trace.agents.values())
    header = ",".join(("time", "agent", *names))
    (times,) = _cells([trace.time])
    lines: list[str] = []
    varying: list[Sequence[Any]] = []
    for name, agent in trace.agents.items():  # the rows of one time
        cells = _cells([getattr(agent, column) for column in names])
        shown = [times[0], _field(name).replace("%", "%%"), *(text for text, _ in cells)]
        lines.append(",".join(shown) + "\n")
        varying += [values for _, values in (times, *cells) if values is not None]
    rows = "".join(lines) * len(trace.time)
    return f"{header}\n{rows % tuple(chain.from_iterable(zip(*varying, strict=True)))}"


def _field(text: str) -> str:
    """A text as CSV has it, in quotes where it needs them."""
    out = io.StringIO()
    csv.writer(out, lineterminator="").writerow((text, ""))
    return out.getvalue()[:-1]


def to_json(trace: Trace) -> str:
    """Columns by agent; what an engine does not report is null."""
    agents = ",".join(
        f"{json.dumps(name)}:{_columns(agent)}" for name, agent in trace.agents.items()
    )
    events = json.dumps([dict(event) for event in trace.events], allow_nan=False, separators=_TIGHT)
    return (
        f'{{"schema":"{TRACE_SCHEMA}","engine":{json.dumps(trace.engine)},'
        f'"time":{_numbers(trace.time)},"agents":{{{agents}}},"events":{events}}}\n'
    )


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
            length=_size(values, name, "length"),
            width=_size(values, name, "width"),
            **_checked(_read(values), name, time),
        )
        for name, values in document["agents"].items()
    }
    return Trace(time, agents, str(document["engine"]), tuple(map(_event, document["events"])))


def _size(values: dict[str, Any], agent: str, name: str) -> float:
    size = values[name]
    if isinstance(size, bool) or not isinstance(size, int | float) or not 0 <= size < math.inf:
        raise ValueError(f"`{name}` of `{agent}` is a length in meters, not {size!r}")
    return float(size)


def _checked(
    columns: dict[str, np.ndarray[Any, Any]], agent: str, time: np.ndarray[Any, Any]
) -> dict[str, np.ndarray[Any, Any]]:
    for name, column in columns.items():
        if column.shape != time.shape:
            found, times = column.size, time.size
            raise ValueError(f"`{name}` of `{agent}` has {found} values for {times} times")
    return columns


def _event(value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ValueError(f"an event is a map, not {value!r}")
    controller_failures([value])
    return value


def _read(values: dict[str, Any]) -> dict[str, np.ndarray[Any, Any]]:
    import numpy as np

    columns = {
        name: np.array(_column(values, name), dtype=float)
        for name in (*COLUMNS, *_ELEVATION)
        if name in values or name not in (*ADDED_COLUMNS, *_ELEVATION)
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


def _columns(agent: AgentTrace) -> str:
    columns = {name: _numbers(getattr(agent, name)) for name in recorded_columns([agent])}
    columns |= {name: json.dumps(getattr(agent, name)) for name in ("length", "width")}
    return "{" + ",".join(f'"{name}":{text}' for name, text in columns.items()) + "}"


def _numbers(values: np.ndarray[Any, Any]) -> str:
    return f"[{floats_text(values.tolist(), ',')}]"


def _cells(columns: Sequence[np.ndarray[Any, Any]]) -> list[tuple[str, Sequence[Any] | None]]:
    """Of each of some columns (T,) how a row shows its value, and the values; a text and None where
    all are the same. 9 significant digits; what is not finite is empty."""
    import numpy as np

    numbers = np.array(columns, dtype=np.float64)
    bits = numbers.view(np.int64)
    same: np.ndarray[Any, Any] = np.logical_and(
        (bits[:, 1:] == bits[:, :1]).all(axis=1), bits.shape[1] > 1
    )
    finite = np.asarray(np.isfinite(numbers).all(axis=1))
    cells: list[tuple[str, Sequence[Any] | None]] = []
    for values, is_same, is_finite in zip(numbers, same.tolist(), finite.tolist(), strict=True):
        if is_same:  # as most columns of counts are
            cells.append((_shown(float(values[0])), None))
        elif is_finite:
            cells.append((_FORMAT, values.tolist()))
        else:
            cells.append(("%s", list(map(_shown, values.tolist()))))
    return cells


def _shown(value: float) -> str:
    return _FORMAT % value if math.isfinite(value) else ""
