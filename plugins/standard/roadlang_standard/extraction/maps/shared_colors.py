"""Colors that streets of a map share with houses, water or parks, as in styles of two colors."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Layer
from ..masks.mask_parts import parts_and_boxes, where_parts, without_specks
from ..masks.skeleton import skeleton
from .map_ribbons import ribbons
from .map_tones import MapTone, map_tone

_UNEVEN, _LENGTH = 0.35, 0.7
"""A color may be shared if less than `_UNEVEN` of its surface keeps its width, but over a length of
at least `_LENGTH` shorter sides of the picture."""
_MOST = 0.7
"""The streets have at least this share of that length: pieces of land that are thin have less."""
_WIDE = 4.3
"""Parts more than this many times as wide as the usual ribbons are water or a park."""
_EXTENT, _EVEN = 40, 0.5
"""Streets have an extent of at least `_EXTENT` pixels, and keep their width on at least `_EVEN` of
their length, ..."""
_ROOT = 0.2
"""and are no tongues of what is wider, which they touch along at most `_ROOT` of their length."""
_AS_WIDE = 1.3
"""or are at most this many times as wide as those usually are."""
_NEXT, _BEYOND, _ON_LAND = 5, 9, 0.6
"""Of what lies `_NEXT` to `_BEYOND` pixels, both halved, beside streets, at least `_ON_LAND` is
land. Where the land has a second color, strips of that between two roads have streets beside them.
"""
_BLACK, _SOME = 80.0, 0.1
"""Woods are darker than `_BLACK`, and land is lighter than these by more than that many gray levels
and covers more than `_SOME` of the picture."""
_SPECK = 8


def with_streets_alone(tones: list[MapTone]) -> list[MapTone]:
    """The tones of a map; of those that streets share, these streets.

    Where black woods cover most of a map in black and white, its land is the next color.
    """
    land, *others = sorted(tones, key=lambda tone: -np.count_nonzero(tone.mask))
    if others and _is_woods(land, others[0]):
        land = others[0]
    return [tone if tone is land else _streets(tone, land.mask) for tone in tones]


def _is_woods(tone: MapTone, land: MapTone) -> bool:
    """Whether a tone is black, and a land far lighter, gray as well, and much of the picture."""
    if not (tone.is_gray and land.is_gray and land.mask.mean() > _SOME):
        return False
    return bool(tone.color.mean() < _BLACK < land.color.mean() - tone.color.mean())


def _streets(tone: MapTone, land: Booleans) -> MapTone:
    """A tone, or the streets alone if it shares its color with them; `land` (h, w)."""
    least = _LENGTH * min(tone.mask.shape)
    # Maps of a few grays have one for streets and houses; land in color is no street.
    if not tone.is_gray or tone.steady >= _UNEVEN or tone.steady_length < least:
        return tone
    mask = _narrow(without_specks(tone.mask, _SPECK))
    count, parts, stats = parts_and_boxes(mask)
    thin = skeleton(mask)
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    lengths = np.bincount(parts[thin], minlength=count)
    even = np.bincount(parts[ribbons(thin, inner).lines], minlength=count)
    extents = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    # A tongue of woods meets these along its root, a street at its end.
    beyond = cv2.dilate((tone.mask & ~mask).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    roots = np.bincount(parts[beyond], minlength=count)
    long = (roots <= _ROOT * lengths) & (extents >= _EXTENT) & (lengths > 0)
    long[0] = False
    streets = long & (even >= _EVEN * lengths)
    if streets.any():
        # Where streets meet often, they are hardly even, but no wider than others.
        usual = float(np.median(inner[thin & where_parts(streets, parts)]))
        streets |= long & (_widths(thin, inner, parts, count) <= _AS_WIDE * usual)
    if even[streets].sum() < least:
        return tone
    found = map_tone(tone.color, where_parts(streets, parts))
    beside = _beside(found.mask) & ~tone.mask
    if np.count_nonzero(beside & land) < _ON_LAND * np.count_nonzero(beside):
        return tone
    if found.steady_length < _MOST * tone.steady_length:
        return tone
    return replace(found, shared=True)


def _beside(mask: Booleans) -> Booleans:
    """What (h, w) lies near a mask, but not next to it, where its edges and casings are."""
    near, far = (
        cv2.dilate(mask.astype(np.uint8), np.ones((side, side), np.uint8)) > 0
        for side in (_NEXT, _BEYOND)
    )
    return np.asarray(far & ~near)


def _widths(thin: Booleans, inner: Layer, parts: NDArray[np.int32], count: int) -> Layer:
    """Half the mean width of each connected part (n,), along its lines."""
    length = np.maximum(np.bincount(parts[thin], minlength=count), 1)
    total = np.bincount(parts[thin], weights=inner[thin], minlength=count)
    return np.asarray(total / length, np.float32)


def _narrow(mask: Booleans) -> Booleans:
    """Without what is far wider than the ribbons of a mask (h, w) usually are."""
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    lines = ribbons(skeleton(mask), inner).lines
    widest = _WIDE * float(np.median(2 * inner[lines] - 1))
    core = (inner <= widest / 2).astype(np.uint8)
    return np.asarray(mask & (cv2.distanceTransform(core, cv2.DIST_L2, 5) > widest / 2))
