"""The table of all drives, for the script of the page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..ir.result_columns import named_in
from .numbers import shown_unit
from .results import ResultRow, Results

MOST_CELLS = 100_000
"""Of a table; in a longer one rows that do not fail are left out."""
_PLACE_UNITS = {
    f"{moment} {name}": unit
    for moment in ("worst", "violation")
    for name, unit in (("time", "s"), ("x", "m"), ("y", "m"), ("station", "m"))
} | {"controller failure time": "s"}


def table_record(results: Results, units: Mapping[str, str], drives: Mapping[int, int]) -> Any:
    """`columns` with unit and whether they hold numbers, and `rows` of `[values, failed, drive]`.

    `units` are SI units of params, draws and expectations; `drives` the numbers of the drives on
    the page by that of their rows.
    """
    rows, left_out = _chosen(results.rows)
    names = _ordered(rows)
    each = [_PLACE_UNITS.get(name) or units.get(named_in(name), "") for name in names]
    columns = [_column(name, unit, rows) for name, unit in zip(names, each, strict=True)]
    factors = [shown_unit(unit)[0] for unit in each]
    return {
        "columns": columns,
        "rows": [
            [
                [_cell(row.values.get(name), f) for name, f in zip(names, factors, strict=True)],
                int(row.has_failed),
                drives.get(row.number),
            ]
            for row in rows
        ],
        "leftOut": left_out,
    }


def _ordered(rows: Sequence[ResultRow]) -> list[str]:
    """The names of the columns: outcomes first, since there may be many draws."""
    draws = {name for row in rows for name in row.draws}
    names = dict.fromkeys(name for row in rows for name in row.values)
    return sorted(names, key=lambda name: name in draws)


def _chosen(rows: Sequence[ResultRow]) -> tuple[Sequence[ResultRow], int]:
    widest = max((len(row.values) for row in rows), default=1)
    most = max(MOST_CELLS // widest, 100)
    if len(rows) <= most:
        return rows, 0
    failing = [row for row in rows if row.has_failed][:most]
    safe = [row for row in rows if not row.has_failed]
    count = most - len(failing)
    chosen = {row.number for row in failing}
    chosen |= {safe[step * len(safe) // count].number for step in range(count)}
    return [row for row in rows if row.number in chosen], len(rows) - len(chosen)


def _column(name: str, unit: str, rows: Sequence[ResultRow]) -> dict[str, Any]:
    draws = any(name in row.draws for row in rows[:50])
    return {"name": name, "unit": shown_unit(unit)[1], "draw": int(draws)}


def _cell(value: Any, factor: float) -> Any:
    if isinstance(value, bool) or value is None:
        return value
    if isinstance(value, int | float):
        return float(f"{value * factor:.5g}") if isinstance(value, float) else value
    return value if isinstance(value, str) else str(value)
