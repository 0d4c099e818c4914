"""Tables of points: with a line of names or without, separated by `,` `;` tabs or blanks."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from roadlang.api import Code, DiagnosticError, diagnose, did_you_mean

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
    rows: list[list[float]] = []
    text = path.read_bytes().decode("utf-8-sig", errors="replace")
    for number, line in enumerate(text.splitlines(), start=1):
        cells = _cells(line.lstrip("# ")) if line.startswith("#") else _cells(line)
        numbers = _numbers(cells)
        if not cells or (line.startswith("#") and numbers is not None):
            continue
        if numbers is None:
            if rows:
                raise _refusal(path, f"line {number} is not a row of numbers")
            names = names if line.startswith("#") and names else tuple(map(str.lower, cells))
            continue
        if rows and len(numbers) != len(rows[0]):
            raise _refusal(path, f"line {number} has {len(numbers)} columns, not {len(rows[0])}")
        rows.append(numbers)
        if len(rows) > _MOST_ROWS:
            raise _refusal(path, f"it has more than {_MOST_ROWS:,} rows")
    if len(rows) < 2:
        raise _refusal(path, "it has fewer than two rows of numbers")
    table = np.asarray(rows, dtype=float)
    if not np.isfinite(table).all():
        raise _refusal(path, "some of its numbers are not finite")
    if len(names) != table.shape[1]:
        names = ("x", "y", "width")[: table.shape[1]]
    return Table(path, names, table)


def _cells(line: str) -> list[str]:
    separator = next((mark for mark in ";,\t" if mark in line), None)
    cells = line.split(separator) if separator else line.split()
    return [cell.strip().strip('"') for cell in cells if cell.strip()]


def _numbers(cells: list[str]) -> list[float] | None:
    try:
        return [float(cell) for cell in cells]
    except ValueError:
        return None


def _plain(name: str) -> str:
    return re.sub(r"_m$", "", name.lower())


def _refusal(path: Path, reason: str) -> DiagnosticError:
    return DiagnosticError(diagnose(Code.UNREADABLE_TABLE, file=path.name, reason=reason))
