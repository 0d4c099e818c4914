"""The printed lines of ruled and squared paper: many straight ones of one direction."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .tones import Layer

_TILTS = np.deg2rad(np.arange(-10.0, 10.01, 0.25))
"""By so much may a sheet be turned."""
_COVERED, _FEWEST = 0.5, 5
"""A printed line is marked on this share of its length at least; ruled paper has so many."""
_HALF, _DARKER = 2.5, 1.25
"""Pixels to both sides of a printed line that belong to it, unless they are so many times as dark
as it is: ink that crosses it."""


def without_ruling(ink: Layer, level: float) -> Layer:
    """The ink (h, w) without printed lines, of which most is above `level`."""
    marked = ink > level
    cleaned = ink
    for upright in (False, True):
        tilt, lines = _printed(marked, upright)
        if len(lines) >= _FEWEST:
            cleaned = np.where(_printed_only(ink, level, upright, tilt, lines), 0, cleaned)
    return np.asarray(cleaned, np.float32)


def _printed(marked: Booleans, upright: bool) -> tuple[float, NDArray[np.intp]]:
    """The slope of the printed lines, and where they are in the middle of the sheet, pixels."""
    thick = cv2.dilate(marked.astype(np.uint8), np.ones((3, 3), np.uint8))
    along, across, length, count = _axes(thick > 0, upright)
    counts = [
        np.bincount(_shifted(along, across, np.tan(tilt), length, count), minlength=count)
        for tilt in _TILTS
    ]
    best = int(np.argmax([float((each.astype(float) ** 2).sum()) for each in counts]))
    found = counts[best]
    highest = cv2.dilate(found.astype(np.float32)[:, None], np.ones((9, 1), np.uint8))[:, 0]
    peaks = (found == highest) & (found > _COVERED * length)
    steps = np.diff(peaks.astype(np.int8), prepend=0, append=0)
    middles = (np.flatnonzero(steps > 0) + np.flatnonzero(steps < 0) - 1) // 2
    return float(np.tan(_TILTS[best])), middles


def _printed_only(
    ink: Layer, level: float, upright: bool, slope: float, lines: NDArray[np.intp]
) -> Booleans:
    """Where there are printed lines (h, w), and no darker ink upon them."""
    along, across, length, count = _axes(np.ones(ink.shape, bool), upright)
    place = _shifted(along, across, slope, length, count).reshape(ink.shape)
    result = np.zeros(ink.shape, bool)
    for line in lines:
        near = np.abs(place - line) <= _HALF
        dark = ink[near & (ink > level)]
        result |= near & (ink < _DARKER * float(np.quantile(dark, 0.75)))
    return result


def _axes(mask: Booleans, upright: bool) -> tuple[NDArray[np.intp], NDArray[np.intp], int, int]:
    """Places of a mask's pixels along and across lines that are `upright` or level; the lengths of
    both axes."""
    y, x = np.nonzero(mask)
    height, width = mask.shape
    return (y, x, height, width) if upright else (x, y, width, height)


def _shifted(
    along: NDArray[np.intp], across: NDArray[np.intp], slope: float, length: int, count: int
) -> NDArray[np.intp]:
    """Where lines of a slope through these places cross the middle of the sheet, pixels."""
    place = np.round(across - (along - length / 2) * slope)
    return np.asarray(np.clip(place, 0, count - 1), np.intp)
