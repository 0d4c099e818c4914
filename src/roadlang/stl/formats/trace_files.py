"""Traces from files: CSV with the positions in the first column, or JSON."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...diagnostics import Code, DiagnosticError, diagnose
from ...files.reading import UnreadableFile, read_file
from .drive_traces import (
    DriveTraceFault,
    columns_of_document,
    columns_of_rows,
    is_document,
    is_table,
)

Columns = tuple[str, list[float], dict[str, list[float]]]


def read_trace(path: str | Path, agent: str | None = None) -> Columns:
    """(name of the axis, positions, signals by name) of a .csv, .tsv or .json file.

    Of a trace that `roadlang run` wrote the signals are `ego.speed` and so on; those of `agent`, or
    of the only agent, are also called `speed`.

    JSON is `{"positions": [...], "signals": {"x": [...]}}`, or columns `{"s": [...], "x": [...]}`,
    or records `[{"s": 0, "x": 1}, ...]`; in the latter two the first key holds the positions. Where
    semicolons part the cells, numbers may have decimal commas. Empty cells become NaN, which a
    formula that reads the signal refuses. Raises DiagnosticError RL340.
    """
    path = Path(path)
    try:
        text = read_file(path).decode("utf-8-sig")
    except UnreadableFile as problem:
        raise _unreadable(path, problem.reason) from None
    except UnicodeDecodeError:
        raise _unreadable(path, "it is not text in UTF-8") from None
    try:
        if path.suffix.lower() == ".json":
            return _from_json(path, text, agent)
        return _from_csv(path, text, agent)
    except DriveTraceFault as fault:
        raise _unreadable(path, str(fault), fault.help) from None


def _from_csv(path: Path, text: str, agent: str | None) -> Columns:
    lines = text.splitlines()
    header = lines[0] if lines else ""
    delimiter = max(",;\t", key=header.count)
    if delimiter == ";":
        lines[1:] = [line.replace(",", ".") for line in lines[1:]]
    rows = list(csv.reader(lines, delimiter=delimiter))
    if not header.strip():
        raise _unreadable(path, "it is empty; a first line names the columns")
    names = [name.strip() for name in rows[0]]
    if all(_is_number(name) for name in names):
        raise _unreadable(path, "the first line has numbers; it must name the columns")
    if len(set(names)) < len(names) or not all(names):
        raise _unreadable(path, "two columns have the same name, or one has none")
    if is_table(names):
        listed = [row for _, row in _rows(path, rows, len(names))]
        return _checked(path, columns_of_rows(names, listed, agent))
    _refuse_agent(agent)
    columns: list[list[float]] = [[] for _ in names]
    for line, row in _rows(path, rows, len(names)):
        for name, column, cell in zip(names, columns, row, strict=True):
            column.append(_number(path, cell, f"line {line}, column `{name}`"))
    return names[0], columns[0], dict(zip(names[1:], columns[1:], strict=True))


def _rows(path: Path, rows: list[list[str]], width: int) -> Iterator[tuple[int, list[str]]]:
    """The rows after the first that are not empty, with their lines; each as wide as the first."""
    for line, row in enumerate(rows[1:], start=2):
        if not any(cell.strip() for cell in row):
            continue
        if len(row) != width:
            raise _unreadable(path, f"line {line} has {len(row)} cells, not {width}")
        yield line, row


def _refuse_agent(agent: str | None) -> None:
    if agent is not None:
        raise DriveTraceFault("it has no agents: it is not the trace of a drive")


def _from_json(path: Path, text: str, agent: str | None) -> Columns:
    try:
        value: Any = json.loads(text)
    except (ValueError, RecursionError) as problem:
        raise _unreadable(path, f"it is not JSON: {problem}") from None
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
    checked = {}
    for name, column in columns.items():
        if not isinstance(column, list):
            raise _unreadable(path, f"`{name}` is not a list of numbers")
        places = (f"`{name}`, sample {index}" for index in range(len(column)))
        checked[name] = [
            _number(path, cell, place) for cell, place in zip(column, places, strict=True)
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


def _number(path: Path, cell: Any, place: str) -> float:
    if cell is None or (isinstance(cell, str) and not cell.strip()):
        return math.nan
    try:
        return float(cell)
    except (TypeError, ValueError):
        raise _unreadable(path, f"{cell!r} in {place} is not a number") from None


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _unreadable(path: Path, problem: str, help: tuple[str, ...] = ()) -> DiagnosticError:
    return DiagnosticError(
        diagnose(Code.UNREADABLE_TRACE, path=str(path), file=path.name, problem=problem, help=help)
    )
