"""What the tags of a TIFF file say of its bands: which are colors, and what has no data."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .tiff import TiffError, TiffTags

_BITS, _COMPRESSION, _PHOTOMETRIC, _SAMPLES, _PLANES = 258, 259, 262, 277, 284
_EXTRA_SAMPLES, _NO_DATA = 338, 42113
_GRAY, _RGB = (0, 1), 2
"""What the first bands are, by the tag of that name."""
_APART = 2
"""Each band on its own, one behind the other."""
_BYTE = 8
_OPACITIES = (1, 2)
"""Kinds of extra bands that say how opaque a pixel is; others hold anything, such as infrared."""
_WITH_OPACITY = (2, 4)
"""Numbers of bands of which the last says how opaque a pixel is."""
_COLORS = 3
_MOST_BANDS = 4
_NOT_READ = {34887: "LERC", 34925: "LZMA", 50000: "Zstandard", 50001: "WebP", 50002: "JPEG XL"}
"""Compressions of GDAL that OpenCV was not built with, by their codes."""


@dataclass(frozen=True, slots=True)
class TiffBands:
    """`has_opacity`: whether the last of two or four bands says how opaque pixels are; `no_data`:
    the value of pixels that show nothing; `unsupported`: what cannot be read, and what to do;
    `is_misread`: whether OpenCV would read this as something else, without a word."""

    has_opacity: bool = True
    no_data: float | None = None
    unsupported: str = ""
    is_misread: bool = False

    @classmethod
    def of(cls, content: bytes) -> TiffBands:
        """Of a TIFF file; of a broken one, what most files have."""
        try:
            tags = TiffTags(content)
            extra = tags.numbers(_EXTRA_SAMPLES)
            has_opacity = not extra or int(extra[-1]) in _OPACITIES
            no_data = _number(tags.text(_NO_DATA))
            return cls(has_opacity, no_data, _unsupported(tags), _is_apart(tags))
        except TiffError:
            return cls()

    @staticmethod
    def in_color(content: bytes) -> bytes:
        """A TIFF file of which the first three of several bands are colors, as programs for
        satellite images write them without saying so: OpenCV would read the first band alone."""
        try:
            tags = TiffTags(content)
            bands, meaning = tags.numbers(_SAMPLES), tags.numbers(_PHOTOMETRIC)
            if bands and bands[0] >= _COLORS and meaning and meaning[0] in _GRAY:
                content = tags.rewritten(_PHOTOMETRIC, [_RGB])
                extra = [int(kind) for kind in tags.numbers(_EXTRA_SAMPLES)]
                if extra:
                    content = TiffTags(content).rewritten(_EXTRA_SAMPLES, extra[_COLORS - 1 :])
        except TiffError:
            pass
        return content

    def colors(self, pixels: NDArray[np.generic]) -> NDArray[np.generic]:
        """(height, width, bands) without a band that is neither a color nor opacity."""
        if self.has_opacity or pixels.ndim == 2:
            return pixels
        bands = pixels.shape[2]
        return pixels[..., : _COLORS if bands > _COLORS else 1 if bands == 2 else bands]

    def shown(self, pixels: NDArray[np.generic]) -> NDArray[np.bool_] | None:
        """(height, width) where pixels (height, width[, bands]) show something; None: everywhere.

        Those less than half opaque show nothing, nor do those that have `no_data` in every band.
        """
        bands = pixels[..., None] if pixels.ndim == 2 else pixels
        shows = np.ones(bands.shape[:2], np.bool_)
        if bands.shape[2] in _WITH_OPACITY:
            shows = np.asarray(bands[..., -1], np.float64) >= _opaque(bands.dtype) / 2.0
            bands = bands[..., :-1]
        if self.no_data is not None:
            shows &= (bands != self.no_data).any(axis=-1)
        return None if shows.all() else shows


def _opaque(kind: np.dtype[np.generic]) -> float:
    return float(np.iinfo(kind.name).max) if kind.kind in "iu" else 1.0


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _unsupported(tags: TiffTags) -> str:
    faults = []
    compression, bands = tags.numbers(_COMPRESSION), tags.numbers(_SAMPLES)
    if compression and int(compression[0]) in _NOT_READ:
        faults.append(f"{_NOT_READ[int(compression[0])]} compression is not supported")
    if bands and bands[0] > _MOST_BANDS:
        faults.append(f"it has {bands[0]:.0f} bands, at most {_MOST_BANDS} can be read")
    if _is_apart(tags):
        faults.append("its bands of more than 8 bits are stored one behind the other")
    if not faults:
        return ""
    options = "-b 1 -b 2 -b 3 -co COMPRESS=LZW -co INTERLEAVE=PIXEL"
    remedy = f"`gdal_translate {options} FILE NEW.tif` writes one that can be read"
    return f"{'; '.join(faults)}: {remedy}"


def _is_apart(tags: TiffTags) -> bool:
    """Whether bands of more than a byte are apart, which OpenCV reads as if they were not."""
    bands, bits, planes = (tags.numbers(tag) for tag in (_SAMPLES, _BITS, _PLANES))
    several = bool(bands) and bands[0] > 1
    return several and bool(planes) and planes[0] == _APART and max(bits, default=1) > _BYTE
