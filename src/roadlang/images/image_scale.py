"""Meters per pixel and place of a picture, from a GeoTIFF's tags or from files beside it."""

from __future__ import annotations

import hashlib
import math
from dataclasses import dataclass
from pathlib import Path

from ..files.reading import UnreadableFile, read_start
from ..files.table_text import number_in
from .gdal_metadata import gdal_metadata
from .georeference import (
    MODEL_TYPE,
    PIXEL_SCALE,
    PROJECTED,
    Georeference,
    geo_keys,
    geotiff_reference,
    named_grid,
    world_file_reference,
)
from .tiff import TiffError, TiffTags

_LINEAR_UNITS = 3076
_WORLD_FILE = 1000
"""bytes of a world file that are looked at: six numbers"""
_PROJECTION_FILE = 20_000
"""bytes of a `.prj` file"""
_METERS = {9001: 1.0, 9002: 0.3048, 9003: 1200 / 3937}
"""EPSG codes of units of length"""
_DEGREES_AT_MOST = 1e-3
"""A pixel of a world file smaller than this is one in degrees: no photo has 1 mm pixels."""


@dataclass(frozen=True, slots=True)
class FoundScale:
    """What a file says of the size and place of the pixels of a picture.

    `meters` per pixel, None where only the place says that, as in degrees; `reference`: the place,
    where it is known; `files`: those beside the picture that say so, their names and sha256.
    """

    meters: float | None
    reference: Georeference | None = None
    files: tuple[tuple[str, str], ...] = ()


def scale_in_file(path: Path, content: bytes, format: str) -> FoundScale | None:
    """The scale and place where the picture says them; None where it says neither."""
    if format == "TIFF":
        scale, reference = _geotiff(content), geotiff_reference(content)
        if scale is not None or reference is not None:
            return FoundScale(scale, reference)
    return _world_file(path) or _gdal_file(path)


def _geotiff(content: bytes) -> float | None:
    try:
        tags = TiffTags(content)
        scale, entries = tags.numbers(PIXEL_SCALE), geo_keys(tags)
    except TiffError:
        return None
    if len(scale) < 2 or entries.get(MODEL_TYPE, PROJECTED) != PROJECTED:
        return None
    meters = _METERS.get(entries.get(_LINEAR_UNITS, 9001))
    return None if meters is None else _usable(math.sqrt(abs(scale[0] * scale[1])) * meters)


def unusable_world_file(path: Path) -> str | None:
    """What is wrong with the world file beside a picture whose scale nothing says; None where
    there is no such file."""
    for candidate in _world_files(path):
        try:
            data = read_start(candidate, _WORLD_FILE)
        except UnreadableFile:
            continue
        words = data.decode("ascii", "replace").split()
        for line, word in enumerate(words[:6], 1):
            if _number(word) is None:
                return f"`{candidate.name}`, line {line}: {word[:40]!r} is not a number"
        if len(words) < 6:
            return f"`{candidate.name}`, line {len(words) + 1}: a world file has six numbers"
        return f"`{candidate.name}`, line 1: the size of a pixel is not a length in meters"
    return None


def _world_files(path: Path) -> list[Path]:
    """Where one may be."""
    ending = path.suffix
    names = [f"{ending[:2]}{ending[-1]}w", f"{ending}w", ".wld"] if len(ending) > 2 else [".wld"]
    return [path.with_suffix(name) for name in names]


def _number(word: str) -> float | None:
    try:
        number = number_in(word)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def _world_file(path: Path) -> FoundScale | None:
    for candidate in _world_files(path):
        try:
            data = read_start(candidate, _WORLD_FILE)
        except UnreadableFile:
            continue
        words = data.decode("ascii", "replace").split()[:6]
        numbers = [number for word in words if (number := _number(word)) is not None]
        if len(numbers) == 6:
            area = abs(numbers[0] * numbers[3] - numbers[1] * numbers[2])
            beside, text = _projection(path)
            reference = world_file_reference(numbers, text) if area else None
            files = ((candidate.name, hashlib.sha256(data).hexdigest()), *beside)
            return FoundScale(_usable(math.sqrt(area)), reference, files)
    return None


def _projection(path: Path) -> tuple[tuple[tuple[str, str], ...], str]:
    """The description of the grid in a file beside a picture, and the name and sha256 of that file;
    nothing where there is none."""
    beside = path.with_suffix(".prj")
    try:
        data = read_start(beside, _PROJECTION_FILE)
    except UnreadableFile:
        stated = gdal_metadata(path)
        return ((), "") if stated is None else ((stated.file,), stated.grid)
    return ((beside.name, hashlib.sha256(data).hexdigest()),), data.decode("utf-8", "replace")


def _gdal_file(path: Path) -> FoundScale | None:
    stated = gdal_metadata(path)
    if stated is None or stated.matrix is None:
        return None
    a, b, _, d, e, _ = stated.matrix
    reference = Georeference(stated.matrix, named_grid(stated.grid))
    return FoundScale(_usable(math.sqrt(abs(a * e - b * d))), reference, (stated.file,))


def _usable(scale: float) -> float | None:
    return scale if math.isfinite(scale) and scale > _DEGREES_AT_MOST else None
