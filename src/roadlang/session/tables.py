"""Tables of scenes, drives and runs as CSV."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas


def columns_of(rows: Iterable[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """Rows as columns: of every name in any row, None where a row lacks it."""
    listed = list(rows)
    names = dict.fromkeys(name for row in listed for name in row)
    return {name: [row.get(name) for row in listed] for name in names}


def frame_of(columns: Mapping[str, Any], index: str) -> pandas.DataFrame:
    """Columns as a data frame, one of them its index. Raises `ImportError` without pandas."""
    import pandas

    return pandas.DataFrame(dict(columns)).set_index(index)


def to_csv(columns: Mapping[str, Sequence[Any]]) -> str:
    """A line of names and one for each row; lists and maps are JSON, None is empty. Integers are
    written without a decimal point, as they are drawn: `8`."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(value) for value in row] for row in zip(*columns.values(), strict=True))
    return out.getvalue()


def _cell(value: Any) -> Any:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list | tuple | dict):
        return json.dumps(value)
    if isinstance(value, float):
        return str(value).removesuffix(".0")
    return "" if value is None else value
