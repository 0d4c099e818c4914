"""Tables of points: with a line of names or without, separated by `,` `;` tabs or blanks. Where
`;` separates, numbers may have decimal commas."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import Code, DiagnosticError, diagnose, did_you_mean, number_in, read_text

if TYPE_CHECKING:
    from roadlang.geometry import Floats


_SIDES = (("w_tr_left_m", "w_tr_right_m"), ("width_left", "width_right"), ("left", "right"))
_MOST_ROWS = 200_000


@dataclass(frozen=True)
class Table:
    """`names` in lower case, `rows` (n, columns) from the `lines` of the file; NaN where a cell is
    no finite number, whose text is in `texts` by row and column."""

    path: Path
    names: tuple[str, ...]
    rows: Floats
    lines: tuple[int, ...]
    texts: Mapping[tuple[int, int], str]

    def columns(self, *wanted: str) -> Floats:
        """(n, len(wanted)); raises RL477 for a column that is not there or has other cells."""
        import numpy as np

        return np.stack([self._column(name) for name in wanted], axis=1)

    def width(self, wanted: str) -> Floats | None:
        """(n,) meters from edge to edge; None where the table has no widths."""
        for left, right in _SIDES:
            if left in self.names and right in self.names:
                return self._column(left) + self._column(right)
        return self._column(wanted) if _plain(wanted) in map(_plain, self.names) else None

    def _column(self, name: str) -> Floats:
        plain = [_plain(known) for known in self.names]
        if _plain(name) not in plain:
            help_ = (*did_you_mean(name, self.names), f"it has {', '.join(self.names)}")
            raise _refusal(self.path, f"no column `{name}`", help_)
        index = plain.index(_plain(name))
        for (row, column), text in self.texts.items():
            if column == index:
                line = self.lines[row]
                shown = f"`{text}`" if text else "an empty cell"
                raise _refusal(self.path, f"{shown} in line {line} is not a finite number")
        return self.rows[:, index]


def read_table(path: Path) -> Table:
    """The numbers of a table; its names are in the first line, or in a comment (`# x_m, y_m`).

    Without names the first columns are x, y and width. Raises RL477.
    """
    import numpy as np

    names: tuple[str, ...] = ()
    has_line_of_names = False
    rows: list[list[float]] = []
    lines: list[int] = []
    texts: dict[tuple[int, int], str] = {}
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        is_comment = line.startswith("#")
        cells = _cells(line.lstrip("# ") if is_comment else line)
        numbers = [_number(cell) for cell in cells]
        are_numbers = not any(map(math.isnan, numbers))
        if not cells or (is_comment and (are_numbers or rows)):
            continue
        if not rows and not are_numbers and (is_comment or not has_line_of_names):
            names = names if is_comment and names else tuple(map(str.lower, cells))
            has_line_of_names |= not is_comment and separator_of(line) is not None
            continue
        if not rows and all(map(math.isnan, numbers)):
            continue  # the units of the columns
        most = len(names) if has_line_of_names else len(rows[0]) if rows else len(numbers)
        if len(numbers) != most:
            raise _refusal(path, f"line {number} has {len(numbers)} columns, not {most}")
        texts |= {(len(rows), i): cells[i] for i, each in enumerate(numbers) if math.isnan(each)}
        rows.append(numbers)
        lines.append(number)
        if len(rows) > _MOST_ROWS:
            raise _refusal(path, f"it has more than {_MOST_ROWS:,} rows")
    if len(rows) < 2:
        raise _refusal(path, "it has fewer than two rows of numbers")
    table = np.asarray(rows, dtype=float)
    if len(names) != table.shape[1]:
        names = ("x", "y", "width")[: table.shape[1]]
    return Table(path, names, table, tuple(lines), texts)


def separator_of(line: str) -> str | None:
    """What parts the cells of a line; None for blanks."""
    return next((mark for mark in ";\t," if mark in line), None)


def _cells(line: str) -> list[str]:
    separator = separator_of(line)
    cells = [cell.strip().strip('"') for cell in line.split(separator)]
    while cells and not cells[-1]:  # lines may end with separators
        del cells[-1]
    return [cell.replace(",", ".") for cell in cells] if separator == ";" else cells


def _number(cell: str) -> float:
    """NaN for what is no finite number."""
    try:
        number = number_in(cell)
    except ValueError:
        return math.nan
    return number if math.isfinite(number) else math.nan


def _plain(name: str) -> str:
    """A name without its unit: `x_m`, `x [m]` and `x (m)` are `x`."""
    return re.sub(r"(?:_m|\s*[\[(]m(?:eters?)?[\])])\Z", "", name.lower())


def _refusal(path: Path, reason: str, help_: tuple[str, ...] = ()) -> DiagnosticError:
    return DiagnosticError(
        diagnose(Code.UNREADABLE_TABLE, file=path.name, reason=reason, help=help_)
    )
