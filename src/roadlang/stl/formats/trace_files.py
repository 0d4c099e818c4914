"""Traces from files: CSV with the positions in the first column, or JSON."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any
from unicodedata import normalize

from ...diagnostics import Code, DiagnosticError, arguments, diagnose
from ...files.reading import UnreadableFile, read_file
from ...files.table_text import decoded, number_in
from .delimited_text import DelimitedText, DelimitedTextFault
from .drive_traces import (
    DriveTraceFault,
    columns_of_document,
    columns_of_rows,
    is_document,
    is_table,
)
from .text_cell import TextCell

Columns = tuple[str, list[float], dict[str, list[Any]]]
"""Name of the axis, positions, and signals by name; a signal may hold texts among its numbers."""


def read_trace(path: str | Path, agent: str | None = None) -> Columns:
    """(name of the axis, positions, signals by name) of a .csv, .tsv or .json file.

    Of a trace that `roadlang run` wrote the signals are `ego.speed` and so on; those of `agent`, or
    of the only agent, are also called `speed`.

    JSON is `{"positions": [...], "signals": {"x": [...]}}`, or columns `{"s": [...], "x": [...]}`,
    or records `[{"s": 0, "x": 1}, ...]`; in the latter two the first key holds the positions.

    Cells are parted by commas, tabs, semicolons (numbers may then have decimal commas) or spaces.
    Lines that begin with `#`, empty lines and a second line of units are skipped. Positions may
    be time stamps of ISO 8601 or `hh:mm:ss`. Empty cells become NaN, which a formula that reads
    the signal refuses, as it refuses texts. Raises DiagnosticError RL340.
    """
    path = arguments.path("path", path)
    if path.suffix.lower() == ".rl":
        help = f"`roadlang run {path.name} -o DIR` writes traces of its drives, DIR/*.trace.csv"
        raise _unreadable(path, "it is a scene file", (help,))
    try:
        data = read_file(path)
        text = decoded(data)
    except UnreadableFile as problem:
        raise _unreadable(path, problem.reason) from None
    except UnicodeDecodeError:
        raise _unreadable(path, "it is not text") from None
    try:
        if path.suffix.lower() == ".json":
            return _from_json(path, text, agent)
        # Line ends other than these are found in the text alone.
        as_it_is = b"\0" not in data and b"\r" not in data
        return _from_csv(path, text, agent, path if as_it_is else None)
    except DriveTraceFault as fault:
        raise _unreadable(path, str(fault), fault.help) from None


def _from_csv(path: Path, text: str, agent: str | None, file: Path | None) -> Columns:
    try:
        table = DelimitedText.of(text)
        if is_table(table.names):
            listed = [cells for _, cells in table.rows()]
            return _checked(path, columns_of_rows(table.names, listed, agent))
        _refuse_agent(agent)
        columns = table.columns(None if table.delimiter == ";" else file)
    except DelimitedTextFault as fault:
        raise _unreadable(path, str(fault)) from None
    return table.names[0], columns[0], dict(zip(table.names[1:], columns[1:], strict=True))


def _refuse_agent(agent: str | None) -> None:
    if agent is not None:
        raise DriveTraceFault("it has no agents: it is not the trace of a drive")


def _from_json(path: Path, text: str, agent: str | None) -> Columns:
    try:
        value: Any = json.loads(text)
    except ValueError as problem:
        raise _unreadable(path, f"it is not JSON: {problem}") from None
    except RecursionError:
        raise _unreadable(path, "its JSON is nested too deeply") from None
    if is_document(value):
        return _checked(path, columns_of_document(value, agent))
    _refuse_agent(agent)
    if isinstance(value, dict) and {"positions", "signals"} <= value.keys():
        value = {"position": value["positions"], **_object(path, value["signals"])}
    if isinstance(value, list):
        value = _columns_of_records(path, value)
    return _checked(path, _object(path, value))


def _checked(path: Path, columns: dict[str, Any]) -> Columns:
    """Columns as numbers; the first holds the positions."""
    if not columns:
        raise _unreadable(path, "it has no columns")
    checked: dict[str, list[Any]] = {}
    for written, column in columns.items():
        name = normalize("NFC", written)
        if not isinstance(column, list):
            raise _unreadable(path, f"`{name}` is not a list of numbers")
        places = (f"`{name}`, sample {index}" for index in range(len(column)))
        checked[name] = [
            _number(path, cell, place, is_signal=bool(checked))
            for cell, place in zip(column, places, strict=True)
        ]
    axis, *names = checked
    for name in names:
        if len(checked[name]) != len(checked[axis]):
            counts = f"{len(checked[name])} values for {len(checked[axis])} positions"
            raise _unreadable(path, f"`{name}` has {counts}")
    return axis, checked[axis], {name: checked[name] for name in names}


def _columns_of_records(path: Path, records: list[Any]) -> dict[str, list[Any]]:
    rows = [_object(path, record) for record in records]
    names = list(rows[0]) if rows else []
    return {name: [row.get(name) for row in rows] for name in names}


def _object(path: Path, value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise _unreadable(path, "it is neither an object of columns nor a list of records")
    return value


def _number(path: Path, cell: Any, place: str, *, is_signal: bool) -> float | TextCell:
    if cell is None or (isinstance(cell, str) and not cell.strip()):
        return math.nan
    try:
        return number_in(cell) if isinstance(cell, str) else float(cell)
    except (TypeError, ValueError):
        if is_signal and isinstance(cell, str):
            return TextCell.at(cell, f"at {place.rpartition(', ')[2]}")
        raise _unreadable(path, f"{cell!r} in {place} is not a number") from None


def _unreadable(path: Path, problem: str, help: tuple[str, ...] = ()) -> DiagnosticError:
    return DiagnosticError(
        diagnose(
            Code.UNREADABLE_TRACE,
            path=str(path),
            file=path.name or str(path),
            problem=problem,
            help=help,
        )
    )
