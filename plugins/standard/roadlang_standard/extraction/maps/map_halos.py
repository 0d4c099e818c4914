"""Letters of a map in the color of its streets, and outlines of letters in it."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image
from ..masks.mask_parts import parts_and_boxes, parts_of, where_parts

_HALO = 0.9
"""A part of the roads with more than this share on letters is an outline of letters, ..."""
_ON_STREET, _EXTENT = 0.2, 40
"""unless streets with an extent of at least `_EXTENT` pixels are more than `_ON_STREET` of the
surroundings of the word."""
_GRAY, _CLEAR = np.array([0.114, 0.587, 0.299]), 60.0
"""Ink differs from the land by more than `_CLEAR` gray levels."""


def are_written_alike(
    image: Image, letters: Booleans, land: NDArray[np.float64], road: NDArray[np.float64]
) -> bool:
    """Whether most `letters` (h, w) of a map (h, w, 3) are as far to the dark or to the light of
    its land as its roads are: outlines of letters are on the other side."""
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)[letters].astype(np.float64) - float(land @ _GRAY)
    clear = gray[np.abs(gray) > _CLEAR]
    away = float((road - land) @ _GRAY)
    return abs(away) > _CLEAR and clear.size > 0 and np.sign(clear.sum()) == np.sign(away)


def without_halos(mask: Booleans, letters: Booleans) -> Booleans:
    """The roads (h, w) of a map without parts about letters (h, w) on land: their outlines have the
    color of streets, but a name on a street has that at both ends."""
    count, parts, stats = parts_and_boxes(mask)
    areas = np.bincount(parts[mask], minlength=count)
    halos = np.bincount(parts[mask & letters], minlength=count) > _HALO * areas
    if not halos.any():
        return mask
    extents = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    streets = mask & where_parts(~halos & (extents >= _EXTENT), parts)
    names, words = parts_of(letters, 8)
    # Of the words, the greater number where two rims meet: there are few such pixels.
    rim = cv2.dilate(words.astype(np.float32), np.ones((3, 3), np.uint8)).astype(np.intp)
    rim[letters] = 0
    street, around = (np.bincount(rim[where], minlength=names) for where in (streets, rim > 0))
    on_street = street > _ON_STREET * around
    on_street[0] = False
    return np.asarray(mask & (where_parts(~halos, parts) | where_parts(on_street, words)))
