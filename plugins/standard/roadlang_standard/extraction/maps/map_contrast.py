"""More contrast for rendered maps that have little of it, and less for JPEGs in black and white."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image, away_from
from .map_tones import EXACT, Tolerance, flat_colors, is_gray

_SAME_TONE, _MARKED, _FAINT, _CLEAR, _MOST_STRETCH = 3, 0.75, 20, 60, 3.0
"""Pixels that differ from the land by more than `_SAME_TONE` gray levels are marked. A map is faint
if the `_MARKED` quantile of their difference is at most `_FAINT`. The contrast is raised until this
quantile is `_CLEAR`, by at most the factor `_MOST_STRETCH`."""
_BROAD = 11
"""Parts that contain a square of this many pixels are ignored: the streets may be faint beside a
river or woods of full contrast, and a pale park does not make them faint."""
_FEWEST = 0.001
"""Streets cover more than this share of a picture; faint pixels beside a broad road cover less."""
_NEARLY_ALL, _FAINT_LOSSY, _THIN_LOSSY = 0.9, 50, 30
"""In a JPEG the noise gets more contrast too, and colors of parks would split. So its contrast is
raised only if the land is gray, and the `_NEARLY_ALL` quantile of the difference is at most
`_FAINT_LOSSY` for all marked pixels and `_THIN_LOSSY` for thin parts."""
_FAINT_GRAY, _NO_HUE, _LIGHT = 25, 8, 128
"""A map is gray if the channels of its marked pixels differ by at most `_NO_HUE` (at the
`_NEARLY_ALL` quantile). If its land is lighter than `_LIGHT`, its streets may differ from the land
by up to `_FAINT_GRAY`, and the limit for thin parts is `_FAINT_LOSSY`: no color can split."""
_STRONG, _ENOUGH = 200, 100
"""In a JPEG, noise at the edges of streets that differ from the land by more than `_STRONG` gray
levels splits their color. The contrast is then lowered until they differ by `_ENOUGH`."""


Colors = Sequence[NDArray[np.float64]]
"""Of a map, (3,) BGR each, most frequent first."""


@dataclass(frozen=True)
class Stretch:
    """More or less contrast about the color `land` (3,) of the land, which becomes `base` (3,)."""

    land: NDArray[np.float64]
    base: NDArray[np.float64]
    times: float

    def of(self, colors: NDArray[Any]) -> NDArray[np.float64]:
        """Colors (..., 3) with this contrast."""
        return np.asarray(np.clip(self.base + (colors - self.land) * self.times, 0, 255).round())

    def picture(self, image: Image) -> Image:
        """A map (h, w, 3) with this contrast."""
        return self.of(image).astype(np.uint8)


def stretch_of(
    image: Image,
    tolerance: Tolerance = EXACT,
    letters: Booleans | None = None,
    colors: Colors | None = None,
) -> Stretch | None:
    """How much more contrast a map (h, w, 3) needs about its land, None if it has enough: otherwise
    lines that differ from it by ten gray levels have no edges of a mixed color.

    Its `letters` (h, w) are not looked at: maps are faint, but not their names. JPEG's noise gets
    more contrast, too: there, all of the map is to be faint. `colors` are its flat colors, if
    known.
    """
    seen = _Contrast.of(image, letters, colors)
    differs = None if seen is None else _faint(seen, tolerance)
    if seen is None or differs is None:
        return None
    # Light land gets darker: otherwise white streets could not differ more from it.
    base = seen.land - max(0.0, float(seen.land.max()) + _CLEAR - 255)
    return Stretch(seen.land, base, min(_MOST_STRETCH, _CLEAR / differs))


def with_contrast(
    image: Image, tolerance: Tolerance = EXACT, letters: Booleans | None = None
) -> Image:
    """A map (h, w, 3), with more contrast about its land where it has little."""
    stretch = stretch_of(image, tolerance, letters)
    return image if stretch is None else stretch.picture(image)


def without_strong_contrast(image: Image, letters: Booleans, colors: Colors | None = None) -> Image:
    """A map (h, w, 3) stored as JPEG, with less contrast about its land if it is in black and
    white; its `letters` (h, w) are not looked at. `colors` are its flat colors, if known."""
    seen = _Contrast.of(image, letters, colors)
    if seen is None or not seen.marked.any():
        return image
    usual = float(np.quantile(seen.away[seen.marked], _MARKED))
    return (
        image if usual <= _STRONG else Stretch(seen.land, seen.land, _ENOUGH / usual).picture(image)
    )


@dataclass(frozen=True)
class _Contrast:
    """A map (h, w, 3), the color (3,) of its land, how far each pixel (h, w) is off that in gray
    levels, and whether this is more than noise and no letter (h, w)."""

    image: Image
    land: NDArray[np.float64]
    away: Image
    marked: Booleans

    @staticmethod
    def of(image: Image, letters: Booleans | None, colors: Colors | None) -> _Contrast | None:
        """That of a map (h, w, 3) with `letters` (h, w); None if it has no flat color."""
        land = (flat_colors(image) if colors is None else colors)[:1]
        if not land:
            return None
        away = away_from(image, land[0])
        differing = away > _SAME_TONE
        return _Contrast(
            image, land[0], away, differing if letters is None else differing & ~letters
        )

    def is_light_gray(self) -> bool:
        """Whether neither the land, which is light, nor nearly all of what is marked has a hue."""
        if not is_gray(self.land) or self.land.mean() < _LIGHT:
            return False
        colors = self.image[self.marked]
        spread = colors.max(axis=1) - colors.min(axis=1)
        return bool(np.quantile(spread, _NEARLY_ALL) <= _NO_HUE)


def _faint(seen: _Contrast, tolerance: Tolerance) -> float | None:
    """How far (gray levels) what is marked on a map is off its land; None if it is not faint."""
    marked = seen.marked.astype(np.uint8)
    broad = cv2.morphologyEx(marked, cv2.MORPH_OPEN, np.ones((_BROAD, _BROAD), np.uint8))
    thin = seen.away[marked > broad]
    if thin.size <= _FEWEST * marked.size:
        return None
    usual = float(np.quantile(thin, _MARKED))
    gray = seen.is_light_gray()
    is_faint = usual <= (_FAINT_GRAY if gray else _FAINT)
    if is_faint and tolerance.is_lossy:
        all_of_it, limit = seen.away[seen.marked], _FAINT_LOSSY if gray else _THIN_LOSSY
        whole, most = (float(np.quantile(part, _NEARLY_ALL)) for part in (all_of_it, thin))
        is_faint = is_gray(seen.land) and whole <= _FAINT_LOSSY and most <= limit
    return usual if is_faint else None
