"""Units that a file states for its columns, against numbers with units in a formula."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ...diagnostics import Code, DiagnosticError, Source, Span, diagnose
from ...files.reading import UnreadableFile, read_start
from ...files.table_text import decoded
from ...syntax.parsing.parser import parse_formula
from .delimited_text import DelimitedText, DelimitedTextFault
from .from_syntax_tree import FormulaReader
from .unit_factors import factor, is_unit

_IN_NAME = re.compile(r".*\S\s*[\[(]\s*([^\[\]()]+?)\s*[\])]\s*", re.DOTALL)
_TIME_IN_NAME = re.compile(r".*[\w)]_(ms|us|ns)", re.DOTALL | re.IGNORECASE)
_LEAST_CLOCK = {"ns": 1e17, "us": 1e14, "ms": 1e11}
"""Time stamps since 1970 in these units are above; in seconds they are below all of them."""
_HEAD = 1 << 16
"""Bytes of a file in which the names and units of its columns are."""


@dataclass(frozen=True)
class ColumnUnits:
    """What a file says of its columns. `units`: by name; the first of `names` is the axis."""

    file: str
    names: tuple[str, ...]
    units: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of_table(cls, file: str, table: DelimitedText) -> ColumnUnits:
        """By the row below the names, or in brackets behind a name: `e [mm]`, `speed (km/h)`. Of
        the axis also by the end of its name (`time_ms`), or as time stamps since 1970 are large."""
        found = {name: _in_name(name) for name in table.names}
        row = zip(table.names, table.unit_row or (), strict=False)
        found |= {name: unit for name, unit in row if unit}
        units = {name: unit for name, unit in found.items() if unit.strip("-1 ")}
        axis = table.names[0]
        if axis not in units and (unit := _of_times(axis, table.first_cell)):
            units[axis] = unit
        return cls(file, table.names, units)

    @classmethod
    def of_file(cls, path: str | Path) -> ColumnUnits:
        """Nothing for files that are no tables."""
        path = Path(path)
        try:
            head = decoded(read_start(path, _HEAD))
            if path.suffix.lower() != ".json":
                return cls.of_table(path.name, DelimitedText.of(head))
        except (UnreadableFile, UnicodeDecodeError, DelimitedTextFault):
            pass  # whoever reads the whole file says so
        return cls(path.name, ())

    def check(self, formula: str) -> None:
        """Raises DiagnosticError RL345 if the text of a formula has a number with a unit, which is
        converted to SI, for a column in another unit: nothing converts the column."""
        expression, _ = parse_formula(Source("<formula>", formula))
        if expression is None:
            return
        reader = FormulaReader()
        reader.formula(expression)
        numbers: dict[str, Span] = dict(reader.compared_with_units)
        if self.names and reader.interval_with_unit is not None:
            numbers[self.names[0]] = reader.interval_with_unit
        faults = [
            diagnose(
                Code.COLUMN_IN_OTHER_UNIT,
                span,
                name=name,
                file=self.file,
                unit=self.units[name],
                number=" ".join(span.text.split()),
                help=f"write it in `{self.units[name]}`, without a unit",
            )
            for name, span in numbers.items()
            if name in self.units and not _is_si(self.units[name])
        ]
        if faults:
            raise DiagnosticError(*faults)


def _in_name(name: str) -> str:
    found = _IN_NAME.fullmatch(name)
    return found[1] if found is not None and is_unit(found[1]) else ""


def _of_times(name: str, first: str) -> str:
    """The unit of the positions that a file does not state otherwise, or nothing."""
    found = _TIME_IN_NAME.fullmatch(name)
    if found is not None:
        return found[1].lower()
    try:
        start = float(first)
    except ValueError:
        return ""
    return next((unit for unit, least in _LEAST_CLOCK.items() if least < start < math.inf), "")


def _is_si(unit: str) -> bool:
    return is_unit(unit) and math.isclose(factor(unit), 1.0)


def check_units(formula: str, paths: Sequence[str]) -> None:
    """`ColumnUnits.check` for files."""
    for path in paths:
        ColumnUnits.of_file(path).check(formula)
