"""What GDAL writes of a picture in a file beside it, `NAME.png.aux.xml`: its grid and its place."""

from __future__ import annotations

import hashlib
import math
import re
from dataclasses import dataclass
from pathlib import Path

from ..files.reading import UnreadableFile, read_start
from ..files.table_text import number_in
from .georeference import Matrix

_LARGEST = 200_000
"""Bytes that are looked at; statistics of the pixels may follow."""
_GRID = re.compile(r"<SRS\b[^>]*>(.*?)</SRS>", re.DOTALL)
_PLACE = re.compile(r"<GeoTransform>(.*?)</GeoTransform>", re.DOTALL)


@dataclass(frozen=True, slots=True)
class GdalMetadata:
    """`grid`: the description of the coordinate system, as in a `.prj` file, or empty; `matrix`:
    from corners of pixels to coordinates, where it is stated; `file`: name and sha256."""

    grid: str
    matrix: Matrix | None
    file: tuple[str, str]


def gdal_metadata(path: Path) -> GdalMetadata | None:
    """Of the file beside the picture `path`; None where there is none that states a grid."""
    beside = path.with_name(f"{path.name}.aux.xml")
    try:
        data = read_start(beside, _LARGEST)
    except UnreadableFile:
        return None
    import html  # its names of characters are only for those who open such a file

    text = data.decode("utf-8", "replace")
    grid, place = _GRID.search(text), _PLACE.search(text)
    if grid is None:
        return None
    matrix = None if place is None else _matrix(place.group(1))
    digest = hashlib.sha256(data).hexdigest()
    return GdalMetadata(html.unescape(grid.group(1)).strip(), matrix, (beside.name, digest))


def _matrix(text: str) -> Matrix | None:
    """GDAL's order: x of the corner, its change by columns and by rows, then the same of y."""
    try:
        c, a, b, f, d, e = (number_in(word) for word in text.split(","))
    except ValueError:
        return None
    is_usable = all(map(math.isfinite, (a, b, c, d, e, f))) and a * e != b * d
    return (a, b, c, d, e, f) if is_usable else None
