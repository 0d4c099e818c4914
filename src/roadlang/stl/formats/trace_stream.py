"""Samples of a CSV trace, line by line as they come."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from .delimited_text import COMMENT, DelimitedText, DelimitedTextFault

StreamedSample = tuple[float, dict[str, Any]]


def samples_of_lines(lines: Iterable[str]) -> Iterator[StreamedSample]:
    """(position, values by name) of each line below the one that names the columns.

    Cells are as in `read_trace`; comments, empty lines and a line of units are skipped. Raises
    DelimitedTextFault for a line that is no sample.
    """
    head: list[str] = []
    names: tuple[str, ...] | None = None
    started = False
    for number, line in enumerate(lines, start=1):
        if names is None:
            head.append(line.rstrip("\r\n"))
            if line.strip() and not line.lstrip().startswith(COMMENT):
                table = DelimitedText.of("\n".join(head) + "\n")
                names, delimiter = table.names, table.delimiter
                first = table.body.strip()
                if first:  # the names stood in a comment
                    started = True
                    yield _sample(names, first, delimiter, number)
            continue
        if not started and _units(names, line, delimiter):
            started = True
            continue
        if line.strip() and not line.lstrip().startswith(COMMENT):
            started = True
            yield _sample(names, line.rstrip("\r\n"), delimiter, number)


def _units(names: tuple[str, ...], line: str, delimiter: str | None) -> bool:
    return DelimitedText(names, line.rstrip("\r\n"), 1, delimiter).unit_row is not None


def _sample(
    names: tuple[str, ...], line: str, delimiter: str | None, number: int
) -> StreamedSample:
    text = line.replace(",", ".") if delimiter == ";" else line
    table = DelimitedText(names, text, number, delimiter)
    columns = table.columns()
    if any(len(column) != 1 for column in columns):
        raise DelimitedTextFault(f"line {number} is not one sample")
    position, *values = (column[0] for column in columns)
    return position, dict(zip(names[1:], values, strict=True))
