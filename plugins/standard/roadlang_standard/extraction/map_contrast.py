"""More contrast for rendered maps that have little of it."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from .map_tones import EXACT, Tolerance, flat_colors, is_gray
from .tones import Image, away_from

_SAME_TONE, _MARKED, _FAINT, _CLEAR, _MOST_STRETCH = 3, 0.75, 20, 60, 3.0
"""A map is faint where what differs from its land by more than the first, in gray levels, does so
by no more than the third in the share of the second; that share is to differ by the fourth, but
contrast is not raised by more than the last factor."""
_BROAD = 11
"""What holds a square of so many pixels is not looked at: a river or woods of full contrast leave
the streets as faint as they are, and a pale park does not make streets pale."""
_FEWEST = 0.001
"""Streets cover more than this share of a picture; faint pixels beside a broad road cover less."""
_NEARLY_ALL, _FAINT_LOSSY, _THIN_LOSSY = 0.9, 50, 30
"""JPEG's noise gets more contrast, too: it is raised only where all that differs, and all of it
that is thin, is off a gray land by no more gray levels in the first share: the colors of parks
would part into several."""


def with_contrast(
    image: Image, tolerance: Tolerance = EXACT, letters: Booleans | None = None
) -> Image:
    """A map (h, w, 3), with more contrast about its land where it has little: otherwise lines that
    differ from it by ten gray levels have no edges of a mixed color.

    Its `letters` (h, w) are not looked at: maps are faint, but not their names. JPEG's noise gets
    more contrast, too: there, all of the map is to be faint.
    """
    land = flat_colors(image)[:1]
    if not land:
        return image
    away = away_from(image, land[0])
    differing = away > _SAME_TONE
    marked = differing if letters is None else differing & ~letters
    differs = _faint(away, marked.astype(np.uint8), tolerance, is_gray(land[0]))
    if differs is None:
        return image
    stretch = min(_MOST_STRETCH, _CLEAR / differs)
    # Light land gets darker: otherwise white streets could not differ more from it.
    base = land[0] - max(0.0, float(land[0].max()) + _CLEAR - 255)
    return np.clip(base + (image - land[0]) * stretch, 0, 255).round().astype(np.uint8)


def _faint(away: Image, marked: Image, tolerance: Tolerance, on_gray: bool) -> float | None:
    """How far (gray levels) what is `marked` (h, w) on a map is off its land, as each pixel is
    `away` (h, w) from that; None if the map is not faint."""
    broad = cv2.morphologyEx(marked, cv2.MORPH_OPEN, np.ones((_BROAD, _BROAD), np.uint8))
    thin = away[marked > broad]
    if thin.size <= _FEWEST * away.size:
        return None
    usual = float(np.quantile(thin, _MARKED))
    is_faint = usual <= _FAINT
    if is_faint and tolerance.is_lossy:
        whole, most = (float(np.quantile(seen, _NEARLY_ALL)) for seen in (away[marked > 0], thin))
        is_faint = on_gray and whole <= _FAINT_LOSSY and most <= _THIN_LOSSY
    return usual if is_faint else None
