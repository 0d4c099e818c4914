"""`read with csv`: a road from a table of points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Reader, String, option


@dataclass(frozen=True)
class Csv(Reader):
    """Read a road as rows of points: columns x and y in metres, with or without a width."""

    name: ClassVar[str] = "csv"
    suffixes: ClassVar[tuple[str, ...]] = (".csv", ".tsv", ".txt")
    reads: ClassVar[tuple[str, ...]] = ("road",)
    x: String = option("x", help="name of the column of eastings")
    y: String = option("y", help="name of the column of northings")
    width: String = option("width", help="name of the column of widths, where there is one")
