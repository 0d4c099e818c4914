"""Tables of numbers in text: the separator, the names of the columns, and what stands around them.

Regular numbers are read by numpy in one go. Only where that fails are cells looked at one by one,
to read what else is common in logs (empty cells, true and false, time stamps) or to say what is
wrong and where.
"""

from __future__ import annotations

import csv
import io
import math
import re
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unicodedata import normalize

import numpy as np

from ...files.table_text import number_in
from .text_cell import TextCell

COMMENT = "#"
_UNPACKED_BY_NUMPY = (".bz2", ".gz", ".lzma", ".xz")
"""Ends of names that numpy takes for compressed files, whatever is in them."""
_MARK_IN_CELL = re.compile(rf"^[ \t]*[^\s{COMMENT}][^\n{COMMENT}]*(?<=\S){COMMENT}", re.MULTILINE)
_QUOTED = re.compile(r'"[^"]*"')
_ISO_8601 = re.compile(
    r"(\d{4}-\d\d-\d\d)[Tt ](\d\d:\d\d:\d\d(?:\.\d{1,9})?)(?:[Zz]|([+-])(\d\d):?(\d\d))?"
)


class DelimitedTextFault(Exception):
    """The text is no table of numbers; the message says why."""


@dataclass(frozen=True)
class DelimitedText:
    """`names` of the columns, with letters in their composed form (NFC); `body` are the lines below
    them, the first of which is line `first` of the file; cells are parted by `delimiter` (None: by
    spaces)."""

    names: tuple[str, ...]
    body: str
    first: int
    delimiter: str | None

    @classmethod
    def of(cls, text: str) -> DelimitedText:
        """Find the names: the first line that is neither empty nor a comment, or the last comment
        before it if that line has numbers only. Raises DelimitedTextFault."""
        rest, line, comment = text if "\n" in text else text.replace("\r", "\n"), 0, ""
        while True:
            if not rest:
                raise DelimitedTextFault("it is empty; a first line names the columns")
            header, _, rest = rest.partition("\n")
            line += 1
            if header.strip() and not header.lstrip().startswith(COMMENT):
                break
            comment = header.strip().lstrip(COMMENT).strip() or comment
        delimiter = _delimiter(header)
        names = [normalize("NFC", name) for name in _cells(header, delimiter)]
        if all(_is_number(name) for name in names):
            comment = normalize("NFC", comment)
            commented = _cells(comment, _delimiter(comment)) if comment else []
            if len(commented) != len(names) or any(map(_is_number, commented)):
                raise DelimitedTextFault("the first line has numbers; it must name the columns")
            names, rest, line = commented, f"{header}\n{rest}", line - 1
        if not names[-1] and not _is_filled(rest, delimiter, len(names)):
            names = names[:-1]  # every line ends with a separator
        if len(set(names)) < len(names) or not all(names):
            raise DelimitedTextFault(_fault_of(names))
        if delimiter == ";":
            rest = rest.replace(",", ".")
        return cls(tuple(names), rest, line + 1, delimiter)

    def rows(self) -> list[tuple[int, list[str]]]:
        """The lines that hold cells, with their numbers; each has a cell for every name.

        Raises DelimitedTextFault for a line of another width.
        """
        found = []
        lines = self.body.splitlines()
        if self.delimiter is None:
            split = [line.split() for line in lines]
        else:
            split = _split(lines, self.delimiter)
        for line, cells in enumerate(split, start=self.first):
            if not any(cell.strip() for cell in cells) or cells[0].lstrip().startswith(COMMENT):
                continue
            if len(cells) == len(self.names) + 1 and not cells[-1].strip():
                cells = cells[:-1]
            if len(cells) != len(self.names):
                raise DelimitedTextFault(
                    f"line {line} has {len(cells)} cells, not {len(self.names)}"
                    f"{self._decimal_commas(cells)}"
                )
            found.append((line, cells))
        return found

    def _decimal_commas(self, cells: list[str]) -> str:
        """What to write where `1,5` may have been one number."""
        is_likely = self.delimiter == "," and all(cell.strip().isdigit() for cell in cells[1:])
        return "; part the cells by `;` if the numbers have decimal commas" if is_likely else ""

    @property
    def unit_row(self) -> tuple[str, ...] | None:
        """The units of the columns, if the first line below the names has them: no number is in
        it. None for a line of another width too."""
        body = (line for line in self.body.splitlines() if line.strip())
        line = next((line for line in body if not line.lstrip().startswith(COMMENT)), "")
        cells = _cells(line, self.delimiter) if line else []
        if len(cells) == len(self.names) + 1 and not cells[-1]:
            cells = cells[:-1]
        is_row = len(cells) == len(self.names) and not any(map(_is_value, cells)) and any(cells)
        return tuple(cells) if is_row else None

    @property
    def first_cell(self) -> str:
        """The first cell of the first line below the names that is no row of units."""
        lines = [
            line
            for line in self.body.splitlines()
            if line.strip() and not line.lstrip().startswith(COMMENT)
        ]
        skipped = 0 if self.unit_row is None else 1
        return _cells(lines[skipped], self.delimiter)[0] if len(lines) > skipped else ""

    def columns(self, file: Path | None = None) -> list[list[Any]]:
        """The columns. Empty cells are NaN, true and false 1 and 0, time stamps of the first
        column seconds (since 1970 where they have a date). `file` is a file that holds the text as
        it is, in an encoding that has ASCII in it: numpy reads files faster than texts.

        Other cells are texts, each with its place. Raises DelimitedTextFault for one in the first
        column, which holds the positions.
        """
        quick = self._regular(file)
        if quick is not None:
            return quick
        rows = self.rows()
        if len(rows) > 1 and not any(map(_is_value, rows[0][1])):
            del rows[0]  # the units of the columns
        columns: list[list[Any]] = [[] for _ in self.names]
        for line, cells in rows:
            for index, (name, cell) in enumerate(zip(self.names, cells, strict=True)):
                value: Any = _value(cell, stamp=index == 0)
                if value is None and index:
                    value = TextCell.at(cell.strip(), f"in line {line}")
                elif value is None:
                    place = f"line {line}, column `{name}`"
                    raise DelimitedTextFault(
                        f"{cell!r} in {place} is not a number{_meant_form(cell)}"
                    )
                columns[index].append(value)
        return columns

    def _regular(self, file: Path | None) -> list[list[float]] | None:
        """The columns if all cells are plain numbers."""
        if not self.body.strip():
            return [[] for _ in self.names]
        if COMMENT in self.body and _MARK_IN_CELL.search(self.body):  # `1.#INF` is not 1
            return None
        if file is not None and file.suffix in _UNPACKED_BY_NUMPY:
            file = None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of a body without any number
            try:
                table = np.loadtxt(
                    io.StringIO(self.body) if file is None else file,
                    delimiter=self.delimiter,
                    comments=COMMENT,
                    ndmin=2,
                    skiprows=0 if file is None else self.first - 1,
                    encoding="latin-1",  # whatever is no number in it is read from the text
                )
            except ValueError:
                return None
        if table.shape[1] != len(self.names):
            return None
        columns: list[list[float]] = table.T.tolist()
        return columns


def _is_filled(rest: str, delimiter: str | None, count: int) -> bool:
    """Whether the first line of cells has something in the last of `count` columns."""
    lines = (line for line in rest.splitlines() if line.strip() and line.lstrip()[0] != COMMENT)
    cells = _cells(next(lines, ""), delimiter)
    return len(cells) == count and bool(cells[-1])


def _fault_of(names: list[str]) -> str:
    """Why these cannot be names of columns."""
    if not names[0]:
        return (
            "column 1, which holds the positions, has no name, as in files of pandas: use"
            ' `to_csv(path, index_label="time")` if the index is the time, else `index=False`'
        )
    if not all(names):
        return f"column {names.index('') + 1} has no name"
    return f"two columns have the same name, `{next(n for n in names if names.count(n) > 1)}`"


def _delimiter(header: str) -> str | None:
    """The separator that occurs most often outside of quotes; without any, spaces part the cells,
    if there are some between words. A comma may be in a name (`v, front`), so it comes last."""
    header = _QUOTED.sub("", header)
    delimiter = max("\t;,", key=header.count)
    if delimiter in header:
        return delimiter
    return "," if len(header.split()) <= 1 else None


def _cells(header: str, delimiter: str | None) -> list[str]:
    if delimiter is None:
        return header.split()
    return [cell.strip() for cell in _split([header.rstrip("\r")], delimiter)[0]]


def _split(lines: list[str], delimiter: str) -> list[list[str]]:
    try:
        return list(csv.reader(lines, delimiter=delimiter, skipinitialspace=True))
    except csv.Error as problem:
        raise DelimitedTextFault(f"it is not a table: {problem}") from None


def _value(cell: str, *, stamp: bool) -> float | None:
    text = cell.strip()
    if not text:
        return math.nan
    try:
        return number_in(text)
    except ValueError:
        pass
    if text.lower() in ("true", "false"):
        return float(text.lower() == "true")
    return _seconds(text) if stamp else None


def _seconds(text: str) -> float | None:
    """`2026-11-22T07:16:01.5Z` counts from 1970, in UTC where no zone is named; `07:16:01.5` from
    midnight."""
    parts = text.split(":")
    if len(parts) == 3 and "-" not in text and all(_is_number(part) for part in parts):
        hours, minutes, seconds = map(float, parts)
        return 3600 * hours + 60 * minutes + seconds
    stamp = _ISO_8601.fullmatch(text)
    if stamp is None:
        return None
    day, time, sign, hours_off, minutes_off = stamp.groups()
    try:
        counted = np.datetime64(f"{day}T{time}", "ns").astype(np.int64)
    except ValueError:  # such as the 31st of February
        return None
    ahead = 3600 * int(hours_off or 0) + 60 * int(minutes_off or 0)
    return float(counted) / 1e9 - (-ahead if sign == "-" else ahead)


def _meant_form(cell: str) -> str:
    """What to write in place of a date or number in another form than those that are read."""
    if re.fullmatch(r"-?\d+,\d+", cell.strip()):
        return f"; write `{cell.strip().replace(',', '.')}`, or part the cells by `;`"
    is_date = re.search(r"\d[./-]\d", cell) or cell.count(":") > 1
    return "; a time stamp is written `2026-11-22T07:16:01.5Z` or `07:16:01.5`" if is_date else ""


def _is_value(cell: str) -> bool:
    return bool(cell.strip()) and _value(cell, stamp=True) is not None


def _is_number(text: str) -> bool:
    try:
        number_in(text)
    except ValueError:
        return False
    return True
