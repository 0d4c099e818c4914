"""Where the pixels of a picture are on a map: from a GeoTIFF's tags, or from a world file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from .tiff import TiffError, TiffTags

PIXEL_SCALE, _TIE_POINT, _TRANSFORMATION, _GEO_KEYS = 33550, 33922, 34264, 34735
MODEL_TYPE, _RASTER_TYPE, _GEOGRAPHIC, _PROJECTED_CODE = 1024, 1025, 2048, 3072
PROJECTED, _IN_DEGREES, _POINTS = 1, 2, 2
_OWN = 32767
"""The code of a grid that the file itself describes."""
_DEGREES = "EPSG:4326"

Matrix = tuple[float, float, float, float, float, float]


@dataclass(frozen=True, slots=True)
class Georeference:
    """The affine map from corners of pixels, columns and rows counted from the upper left corner
    of the picture, to coordinates: x = m[0] column + m[1] row + m[2], y = m[3] column + m[4] row +
    m[5]. `grid` says of what: "EPSG:32632", or the description in a file such as `.prj`; empty if
    not known.
    """

    matrix: Matrix
    grid: str

    def at(self, column: float, row: float) -> tuple[float, float]:
        """The coordinates of a corner of a pixel."""
        a, b, c, d, e, f = self.matrix
        return a * column + b * row + c, d * column + e * row + f


def geotiff_reference(content: bytes) -> Georeference | None:
    """Of a GeoTIFF (OGC 19-008r4, annex C and requirements 9 to 11); None if it has no place."""
    try:
        tags = TiffTags(content)
        scale, ties = tags.numbers(PIXEL_SCALE), tags.numbers(_TIE_POINT)
        whole, keys = tags.numbers(_TRANSFORMATION), geo_keys(tags)
    except TiffError:
        return None
    if len(whole) == 16:
        matrix: Matrix = (whole[0], whole[1], whole[3], whole[4], whole[5], whole[7])
    elif len(scale) >= 2 and len(ties) >= 6:
        (column, row, _, x, y), (across, down) = ties[:5], scale[:2]
        matrix = (across, 0.0, x - across * column, 0.0, -down, y + down * row)
    else:
        return None
    if keys.get(_RASTER_TYPE) == _POINTS:
        matrix = _from_middles(matrix)
    return Georeference(matrix, _grid(keys))


def geo_keys(tags: TiffTags) -> dict[int, int]:
    """The numbers of a GeoTIFF by the ids of their keys. Raises TiffError."""
    keys = tags.numbers(_GEO_KEYS)
    # Four numbers a key: its id, where its value is (0: here), how many, the value.
    return {int(keys[i]): int(keys[i + 3]) for i in range(4, len(keys) - 3, 4)}


def _grid(keys: dict[int, int]) -> str:
    kind = keys.get(MODEL_TYPE)
    code = keys.get(_GEOGRAPHIC if kind == _IN_DEGREES else _PROJECTED_CODE, _OWN)
    if kind not in (PROJECTED, _IN_DEGREES) or code in (0, _OWN):
        return _DEGREES if kind == _IN_DEGREES else ""
    return f"EPSG:{code}"


def world_file_reference(numbers: Sequence[float], projection: str) -> Georeference:
    """Of the six numbers of a world file, and the description of its grid, if there is one.

    Without one, coordinates that can be degrees in pixels of less than 100 m are longitude and
    latitude.
    """
    a, d, b, e, c, f = numbers
    small = max(map(abs, (a, b, d, e))) < 1e-3
    in_degrees = small and abs(c) <= 180.0 and abs(f) <= 90.0
    grid = named_grid(projection) if projection else _DEGREES if in_degrees else ""
    return Georeference(_from_middles((a, b, c, d, e, f)), grid)


def _from_middles(matrix: Matrix) -> Matrix:
    """Of corners of pixels, from that of their middles."""
    a, b, c, d, e, f = matrix
    return a, b, c - (a + b) / 2.0, d, e, f - (d + e) / 2.0


def named_grid(projection: str) -> str:
    """The EPSG code in the description of a grid, if it is one of the usual; else all of it."""
    text = projection.strip()
    codes = re.findall(r'(?:AUTHORITY|ID)\[\s*"EPSG"\s*,\s*"?(\d+)"?\s*\]\s*\]\s*$', text)
    if codes:
        return f"EPSG:{codes[0]}"
    if text.upper().startswith(("GEOGCS", "GEOGCRS")):
        return _DEGREES
    title = (re.findall(r'"([^"]*)"', text) or [""])[0].replace("_", " ")
    zone = re.search(r"UTM zone (\d{1,2})([NS])$", title, re.IGNORECASE)
    of_wgs = re.match(r"WGS (19)?84\b", title, re.IGNORECASE)
    if zone and of_wgs:
        return f"EPSG:{(32600 if zone.group(2).upper() == 'N' else 32700) + int(zone.group(1))}"
    if of_wgs and re.search(r"(pseudo.?mercator|web mercator)", title, re.IGNORECASE):
        return "EPSG:3857"
    return text
