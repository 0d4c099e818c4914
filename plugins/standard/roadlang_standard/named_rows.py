"""Tables with a line of names, whose cells may be texts: recordings."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from roadlang.api import Code, DiagnosticError, diagnose, number_in

from .csv_table import separator_of

if TYPE_CHECKING:
    from roadlang.geometry import Floats

Rows: TypeAlias = list[dict[str, str]]
_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d+$)")
_MOST_SHOWN = 30


def named_rows(file: Path, text: str) -> Rows:
    """The rows by the names in the first line that is no comment; blank lines are left out.

    Raises RL477 for what is no table.
    """
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    separator = (separator_of(lines[0]) if lines else None) or ","
    try:
        rows = list(csv.reader(lines, delimiter=separator, skipinitialspace=True))
    except csv.Error as error:
        raise table_fault(file, str(error)) from error
    names = [name.strip() for name in rows[0]] if rows else []
    found: Rows = []
    for number, row in enumerate(rows[1:], start=1):
        if len(row) != len(names):
            reason = f"row {number} has {len(row)} columns, not {len(names)}"
            raise table_fault(file, reason)
        cells = [cell.strip() for cell in row]
        if separator == ";":
            cells = [_DECIMAL_COMMA.sub(".", cell) for cell in cells]
        found.append(dict(zip(names, cells, strict=True)))
    return found


def column(file: Path, rows: Rows, name: str) -> Floats:
    """(n,) the numbers of a column. Raises RL477 for a cell that is no finite number."""
    import numpy as np

    numbers = np.empty(len(rows))
    for index, row in enumerate(rows):
        try:
            numbers[index] = number_in(row[name])
        except ValueError:
            numbers[index] = np.nan
        if not np.isfinite(numbers[index]):
            found = f"`{name}` is {_shown(row[name])} in row {index + 1}"
            reason = f"not all of its values are numbers: {found}"
            raise table_fault(file, reason)
    return numbers


def _shown(cell: str) -> str:
    if not cell:
        return "empty"
    return f"`{cell}`" if len(cell) <= _MOST_SHOWN else f"`{cell[:_MOST_SHOWN]}...`"


def table_fault(file: Path, reason: str, help_: tuple[str, ...] = ()) -> DiagnosticError:
    """RL477: the table cannot be read."""
    return DiagnosticError(
        diagnose(Code.UNREADABLE_TABLE, file=file.name, reason=reason, help=help_)
    )
