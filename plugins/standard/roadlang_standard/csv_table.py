"""Tables of points: with a line of names or without, separated by `,` `;` tabs or blanks. Where
`;` separates, numbers may have decimal commas."""

from __future__ import annotations

import math
import re
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
    """`names` in lower case without a unit (`x_m` is `x`), `rows` (n, columns)."""

    path: Path
    names: tuple[str, ...]
    rows: Floats

    def columns(self, *wanted: str) -> Floats:
        """(n, len(wanted)); raises RL477 for a column that is not there."""
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
            raise DiagnosticError(
                diagnose(
                    Code.UNREADABLE_TABLE,
                    file=self.path.name,
                    reason=f"no column `{name}`",
                    help=help_,
                )
            )
        return self.rows[:, plain.index(_plain(name))]


def read_table(path: Path) -> Table:
    """The numbers of a table; its names are in the first line, or in a comment (`# x_m, y_m`).

    Without names the first columns are x, y and width. Raises RL477.
    """
    import numpy as np

    names: tuple[str, ...] = ()
    has_line_of_names = False
    rows: list[list[float]] = []
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        is_comment = line.startswith("#")
        cells = _cells(line.lstrip("# ") if is_comment else line)
        numbers = _numbers(cells)
        if not cells or (is_comment and numbers is not None):
            continue
        if numbers is None:
            if rows:
                odd = next(cell for cell in cells if _numbers([cell]) is None)
                raise _refusal(path, f"line {number} is not a row of numbers: `{odd}`")
            names = names if is_comment and names else tuple(map(str.lower, cells))
            has_line_of_names |= not is_comment and separator_of(line) is not None
            continue
        most = len(names) if has_line_of_names else len(rows[0]) if rows else len(numbers)
        if len(numbers) != most:
            raise _refusal(path, f"line {number} has {len(numbers)} columns, not {most}")
        if not all(map(math.isfinite, numbers)):
            raise _refusal(path, f"line {number} has numbers that are not finite")
        rows.append(numbers)
        if len(rows) > _MOST_ROWS:
            raise _refusal(path, f"it has more than {_MOST_ROWS:,} rows")
    if len(rows) < 2:
        raise _refusal(path, "it has fewer than two rows of numbers")
    table = np.asarray(rows, dtype=float)
    if len(names) != table.shape[1]:
        names = ("x", "y", "width")[: table.shape[1]]
    return Table(path, names, table)


def separator_of(line: str) -> str | None:
    """What parts the cells of a line; None for blanks."""
    return next((mark for mark in ";\t," if mark in line), None)


def _cells(line: str) -> list[str]:
    separator = separator_of(line)
    cells = [cell.strip().strip('"') for cell in line.split(separator)]
    if separator == ";":
        cells = [cell.replace(",", ".") for cell in cells]
    return [cell for cell in cells if cell]


def _numbers(cells: list[str]) -> list[float] | None:
    try:
        return [number_in(cell) for cell in cells]
    except ValueError:
        return None


def _plain(name: str) -> str:
    return re.sub(r"_m$", "", name.lower())


def _refusal(path: Path, reason: str) -> DiagnosticError:
    return DiagnosticError(diagnose(Code.UNREADABLE_TABLE, file=path.name, reason=reason))
