"""The printed lines of ruled and squared paper: many straight ones of one direction."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans, Floats

from ..colors.tones import Layer

_TILTS = np.deg2rad(np.arange(-10.0, 10.01, 0.25))
"""Angles by which a sheet may be rotated."""
_COVERED, _FEWEST = 0.5, 5
"""A printed line is visible on at least `_COVERED` of its length; ruled paper has at least
`_FEWEST`."""
_FANS = np.linspace(-0.16, 0.16, 41)
"""By how much the slopes of the lines differ over the picture, where it was taken at an angle."""
_NARROWER = 5.0
"""The best fan is then found between those tried, so many times as fine."""
_HALF, _DARKER = 2.5, 1.1
"""Pixels within `_HALF` of a printed line belong to it unless they are at least `_DARKER` times as
dark: ink that crosses it."""
_BARE, _VARIES, _BOLDEST, _BOLD = 0.2, 1.3, 2.7, 0.2
"""A printed line is at most `_VARIES` times as dark as its palest `_BARE`, and `_BOLDEST` times as
dark as most printed ones, or something was drawn along it; at least `_BOLD` of them are as dark as
the darkest. Lines between two rows of pixels are half as dark as those on one."""
_EVERY = 4
"""The rotation is estimated from every fourth pixel along the lines."""
_TOP, _AS_DARK = 0.02, 0.8
"""The darkest ink is the `_TOP` quantile; lines at least `_AS_DARK` as dark as it may have been
drawn, ..."""
_GOES_ON = 0.5
"""A line extends as far as it is `_GOES_ON` as dark: the printed lines that cross it are paler."""
_MANY, _ACROSS, _UNEVEN = 12, 0.93, 0.12
"""and were if two of these hold: there are fewer than `_MANY`; they usually extend over less than
`_ACROSS` of the sheet; they deviate from even spacing by more than `_UNEVEN` of the spacing."""

_MARGIN, _PEN = 4.0, 0.5
"""Fewer lines across the printed ones are margins if they take less than `_PEN` of the light, and
less than `_MARGIN` times what the printed ones take."""


def without_ruling(ink: Layer, level: float) -> Layer:
    """The ink (h, w) without printed lines, of which most is above `level`."""
    marked = ink > level
    seen = ink[marked]
    darkest = float(np.quantile(seen, 1 - _TOP)) if len(seen) else 0.0
    cleaned, tones = ink, [0.0, 0.0]
    few: list[_Lines | None] = [None, None]
    for upright in (False, True):
        fan, lines = _straight(marked, upright)
        near = _near(marked, upright, fan, lines)
        if not len(near.lines):
            continue
        if len(near.lines) < _FEWEST:
            few[upright] = near
        elif not near.are_drawn(ink, darkest):
            cleaned = np.where(near.printed(ink), 0, cleaned)
            tones[upright] = float(np.median(near.darkness(ink)))
    for margin, tone in zip(few, reversed(tones), strict=True):
        if margin is not None and margin.are_margins(ink, tone):
            cleaned = np.where(margin.printed(ink), 0, cleaned)
    return np.asarray(cleaned, np.float32)


@dataclass(frozen=True)
class _Fan:
    """Straight lines that have a slope in the middle of a picture; seen at an angle they meet far
    away, and over the picture their slopes differ by `spread`."""

    slope: float
    spread: float = 0.0

    def middles(
        self, along: NDArray[np.intp], across: NDArray[np.intp], length: int, count: int
    ) -> NDArray[np.intp]:
        """Where the lines through these places cross the middle of the sheet, pixels."""
        off = length / 2 - np.arange(length)
        turn = self.spread / count
        aside = np.round(off * (self.slope - turn * count / 2))
        if not turn:
            return np.asarray(np.clip(across + aside.astype(np.intp)[along], 0, count - 1), np.intp)
        nearer = 1 / (1 - off * turn)
        middles = np.round((across + aside[along]) * nearer[along]).astype(np.intp)
        return np.asarray(np.clip(middles, 0, count - 1))


def _straight(marked: Booleans, upright: bool) -> tuple[_Fan, NDArray[np.intp]]:
    """Straight lines, and where they are in the middle of the sheet, pixels."""
    thick = cv2.dilate(marked.astype(np.uint8), np.ones((3, 3), np.uint8))
    across, along = np.nonzero(thick.T if upright else thick)
    count, length = thick.shape[::-1] if upright else thick.shape
    every = along % _EVERY == 0
    some = along[every], across[every]

    def best(fans: list[_Fan]) -> _Fan:
        # The first and the last count what is beside the picture, too.
        counts = (_counts(*some, fan, length, count)[1:-1].astype(float) for fan in fans)
        sums = [float((each**2).sum()) for each in counts]
        return fans[int(np.argmax(sums))]

    fan = best([_Fan(float(np.tan(tilt))) for tilt in _TILTS])
    peaks = _peaks(_counts(along, across, fan, length, count), length)
    spread = best([_Fan(fan.slope, float(each)) for each in _FANS])
    spread = _refined(spread, best)
    others = _peaks(_counts(along, across, spread, length, count), length)
    return (spread, others) if len(others) > max(len(peaks), _FEWEST) else (fan, peaks)


def _refined(fan: _Fan, best: Callable[[list[_Fan]], _Fan]) -> _Fan:
    """The best of those near a fan: the slope in the middle and the spread, one after the other."""
    tilt, turn = float(_TILTS[1] - _TILTS[0]), float(_FANS[1] - _FANS[0])
    near = np.arange(-_NARROWER, _NARROWER + 1) / _NARROWER
    for _ in range(2):
        fan = best([_Fan(fan.slope + float(each) * 4 * tilt, fan.spread) for each in near])
        fan = best([_Fan(fan.slope, fan.spread + float(each) * 4 * turn) for each in near])
    for _ in range(2):
        fan = best([_Fan(fan.slope + float(each) * tilt, fan.spread) for each in near])
        fan = best([_Fan(fan.slope, fan.spread + float(each) * turn) for each in near])
    return fan


def _peaks(found: NDArray[np.intp], length: int) -> NDArray[np.intp]:
    """Where lines are, given how many places of each are marked."""
    highest = cv2.dilate(found.astype(np.float32)[:, None], np.ones((9, 1), np.uint8))[:, 0]
    peaks = (found == highest) & (found > _COVERED * length)
    steps = np.diff(peaks.astype(np.int8), prepend=0, append=0)
    return (np.flatnonzero(steps > 0) + np.flatnonzero(steps < 0) - 1) // 2


def _counts(
    along: NDArray[np.intp], across: NDArray[np.intp], fan: _Fan, length: int, count: int
) -> NDArray[np.intp]:
    """How many places lines go through, by where they are in the middle."""
    return np.bincount(fan.middles(along, across, length, count), minlength=count)


@dataclass(frozen=True)
class _Lines:
    """Straight lines (n,) by where they are in the middle of the sheet; the `pixels` (m,) of a
    picture (h, w) about them, the `line` of each and where it is `along` it; which are `marked`."""

    lines: NDArray[np.intp]
    length: int
    shape: tuple[int, ...]
    pixels: NDArray[np.intp]
    line: NDArray[np.intp]
    along: NDArray[np.intp]
    marked: Booleans

    def darkness(self, ink: Layer) -> Floats:
        """Of the marked pixels of each line, above their usual one (n,)."""
        seen, line = ink.ravel()[self.pixels], self.line
        return np.array(
            [np.quantile(seen[self.marked & (line == i)], 0.75) for i in range(len(self.lines))]
        )

    def _middles(self, ink: Layer) -> Floats:
        """How dark the middle of each line usually is (n,), whatever is drawn along most of it."""
        cells = self.line * self.length + self.along
        darkest = np.zeros(len(self.lines) * self.length, np.float32)
        np.maximum.at(darkest, cells[self.marked], ink.ravel()[self.pixels[self.marked]])
        rows = darkest.reshape(-1, self.length)
        low, usual = np.transpose([np.quantile(row[row > 0], (_BARE, 0.5)) for row in rows])
        return np.asarray(np.minimum(usual, _VARIES * low))

    def are_drawn(self, ink: Layer, darkest: float) -> bool:
        """Whether they are streets that somebody drew."""
        tones = self.darkness(ink)
        if np.median(tones) < _AS_DARK * darkest:
            return False
        across = self._across(ink, tones)
        apart = np.diff(self.lines) / np.median(np.diff(self.lines))
        uneven = float(np.abs(apart - np.maximum(1, np.round(apart))).max())
        signs = (len(self.lines) < _MANY, across < _ACROSS, uneven > _UNEVEN)
        return sum(signs) >= 2

    def _across(self, ink: Layer, tones: Floats) -> float:
        """The share of the sheet over which they usually extend, given how dark they are (n,)."""
        seen = self.marked & (ink.ravel()[self.pixels] > _GOES_ON * tones[self.line])
        ends = [self.along[seen & (self.line == i)] for i in range(len(self.lines))]
        return float(np.median([np.ptp(end) for end in ends])) / self.length

    def are_margins(self, ink: Layer, tone: float) -> bool:
        """Whether they are margins of a sheet with ruling of this darkness across them, 0 if it has
        none."""
        tones = self.darkness(ink)
        darkest = float(tones.max())
        return darkest < min(_MARGIN * tone, _PEN) and self._across(ink, tones) >= _ACROSS

    def printed(self, ink: Layer) -> Booleans:
        """Where the lines are (h, w), and no darker ink upon them."""
        tones = self._middles(ink)
        usual = np.median(tones)
        tones = np.where(tones > _BOLDEST * usual, usual, tones)
        least = _DARKER * np.minimum(tones, np.quantile(tones, 1 - _BOLD, method="higher"))
        result = np.zeros(self.shape, bool)
        result.ravel()[self.pixels] = ink.ravel()[self.pixels] < least[self.line]
        return result


def _near(marked: Booleans, upright: bool, fan: _Fan, lines: NDArray[np.intp]) -> _Lines:
    """The lines with what is near them in a picture; not those that are only beside what is marked:
    each has marked pixels."""
    rows, columns = np.ogrid[: marked.shape[0], : marked.shape[1]]
    across, along = (columns, rows) if upright else (rows, columns)
    count, length = marked.shape[::-1] if upright else marked.shape
    which = np.full(count, -1, np.intp)
    for index, line in enumerate(lines.tolist()):
        which[max(0, line - int(_HALF)) : line + int(_HALF) + 1] = index
    owner = which[fan.middles(along, across, length, count)].ravel()
    pixels = np.flatnonzero(owner >= 0)
    seen = np.bincount(owner[pixels[marked.ravel()[pixels]]], minlength=len(lines)) > 0
    if not seen.all():
        return _near(marked, upright, fan, lines[seen])
    row, column = np.divmod(pixels, marked.shape[1])
    return _Lines(
        lines,
        length,
        marked.shape,
        pixels,
        owner[pixels],
        row if upright else column,
        marked.ravel()[pixels],
    )
