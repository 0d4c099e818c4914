"""Letters of a map in the color of its streets, and outlines of letters in it."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from .map_tones import MapTone, map_tone

_HALO = 0.6
"""A part of the roads of which more is about letters is an outline of letters, ..."""
_ON_STREET, _EXTENT = 0.2, 40
"""unless streets that reach over so many pixels are so much of what is around the word."""
_STEADY, _RIBBONS = 0.4, 0.9
"""Names may be among the shapes of a tone that keeps its width on more of its surface than the
first, and has less of it in ribbons than the second."""


def without_names(tones: list[MapTone], names: Booleans) -> list[MapTone]:
    """The tones of a map without their parts about names (h, w), which are in the color of some
    streets, or outlined in it: a map of few streets may have more of them."""
    land = max(tones, key=lambda tone: float(tone.mask.sum()))
    return [tone if tone is land else _without_names(tone, names) for tone in tones]


def _without_names(tone: MapTone, names: Booleans) -> MapTone:
    if tone.steady < _STEADY or tone.ribbons > _RIBBONS:
        return tone
    return map_tone(tone.color, without_halos(tone.mask, names))


def without_halos(mask: Booleans, letters: Booleans) -> Booleans:
    """The roads (h, w) of a map without parts about letters (h, w) on land: their outlines have the
    color of streets, but a name on a street has that at both ends."""
    count, parts, stats, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8), connectivity=8)
    areas = np.bincount(parts[mask], minlength=count)
    halos = np.bincount(parts[mask & letters], minlength=count) > _HALO * areas
    if not halos.any():
        return mask
    extents = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    streets = mask & ~halos[parts] & (extents >= _EXTENT)[parts]
    names, words = cv2.connectedComponents(letters.astype(np.uint8), connectivity=8)
    # Of the words, the greater number where two rims meet: there are few such pixels.
    rim = cv2.dilate(words.astype(np.float32), np.ones((3, 3), np.uint8)).astype(np.intp)
    rim[letters] = 0
    street, around = (np.bincount(rim[where], minlength=names) for where in (streets, rim > 0))
    on_street = street > _ON_STREET * around
    on_street[0] = False
    return np.asarray(mask & (~halos[parts] | on_street[words]))
