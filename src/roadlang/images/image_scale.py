"""Meters per pixel from a GeoTIFF's tags or from a world file next to a picture."""

from __future__ import annotations

import hashlib
import math
from dataclasses import dataclass
from pathlib import Path

from ..files.reading import UnreadableFile, read_start
from .tiff import TiffError, TiffTags

_PIXEL_SCALE, _GEO_KEYS = 33550, 34735
_MODEL_TYPE, _LINEAR_UNITS = 1024, 3076
_PROJECTED = 1
_WORLD_FILE = 1000
"""bytes of a world file that are looked at: six numbers"""
_METERS = {9001: 1.0, 9002: 0.3048, 9003: 1200 / 3937}
"""EPSG codes of units of length"""
_DEGREES_AT_MOST = 1e-3
"""A pixel of a world file smaller than this is one in degrees: no photo has 1 mm pixels."""


@dataclass(frozen=True, slots=True)
class FoundScale:
    """`meters` per pixel; of a world file next to the picture also its name and sha256."""

    meters: float
    world_file: str = ""
    sha256: str = ""


def scale_in_file(path: Path, content: bytes, format: str) -> FoundScale | None:
    """The scale where the picture says it; None where it does not, or only in degrees."""
    if format == "TIFF":
        found = _geotiff(content)
        if found is not None:
            return FoundScale(found)
    return _world_file(path)


def _geotiff(content: bytes) -> float | None:
    try:
        tags = TiffTags(content)
        scale, keys = tags.numbers(_PIXEL_SCALE), tags.numbers(_GEO_KEYS)
    except TiffError:
        return None
    if len(scale) < 2:
        return None
    # Four numbers a key: its id, where its value is (0: here), how many, the value.
    entries = {int(keys[i]): int(keys[i + 3]) for i in range(4, len(keys) - 3, 4)}
    if entries.get(_MODEL_TYPE, _PROJECTED) != _PROJECTED:
        return None
    meters = _METERS.get(entries.get(_LINEAR_UNITS, 9001))
    return None if meters is None else _usable(math.sqrt(abs(scale[0] * scale[1])) * meters)


def _world_file(path: Path) -> FoundScale | None:
    ending = path.suffix
    names = [f"{ending[:2]}{ending[-1]}w", f"{ending}w", ".wld"] if len(ending) > 2 else [".wld"]
    for name in names:
        candidate = path.with_suffix(name)
        try:
            data = read_start(candidate, _WORLD_FILE)
            numbers = [float(word) for word in data.decode("ascii").split()[:6]]
        except (UnreadableFile, ValueError):
            continue
        if len(numbers) == 6:
            area = abs(numbers[0] * numbers[3] - numbers[1] * numbers[2])
            scale = _usable(math.sqrt(area))
            digest = hashlib.sha256(data).hexdigest()
            return None if scale is None else FoundScale(scale, candidate.name, digest)
    return None


def _usable(scale: float) -> float | None:
    return scale if math.isfinite(scale) and scale > _DEGREES_AT_MOST else None
