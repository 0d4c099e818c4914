"""Where an arm bends so sharply that its inner border crosses itself: no road begins there."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

from ..arrays import Booleans, Floats, cross

Span: TypeAlias = tuple[float, float]
"""From one distance from the node to another, meters."""

_LOOK = 40.0
"""Meters before and after a fold in which its borders are looked for a crossing."""
_MARGIN = 0.05
_SAME_BEND = 2.0
_LEAST_DEPTH = 0.01
"""Meters that a border runs backward: less is a curb that turns about a point."""


def folded_spans(s: Floats, points: Floats, borders: tuple[Floats, Floats]) -> tuple[Span, ...]:
    """The spans of an arm (stations (n,), points (n, 2), both borders (n, 2)) in which the surface
    before a bend and that after it overlap, in order."""
    spans = [span for border in borders for span in _spans(s, points, border)]
    return tuple(sorted(spans))


def past(spans: tuple[Span, ...], distance: float) -> float:
    """The distance itself, or the end of the spans that it lies in."""
    for start, stop in spans:
        if start < distance < stop:
            distance = stop
    return distance


def _spans(s: Floats, points: Floats, border: Floats) -> list[Span]:
    along, steps = np.diff(points, axis=0), np.diff(border, axis=0)
    backward = np.flatnonzero((along * steps).sum(axis=1) < 0.0)
    if not len(backward):
        return []
    bends = np.split(backward, np.flatnonzero(np.diff(s[backward]) > _SAME_BEND) + 1)
    size = np.hypot(*steps.T)
    return [
        _span(s, border, int(bend[0]), int(bend[-1]) + 1)
        for bend in bends
        if size[bend].sum() > _LEAST_DEPTH
    ]


def _span(s: Floats, border: Floats, first: int, last: int) -> Span:
    """From where the border before a fold crosses the border after it, to that place after it;
    where they do not cross, the fold alone."""
    before = np.arange(int(np.searchsorted(s, s[first] - _LOOK)), first)
    after = np.arange(last, int(np.searchsorted(s, s[last] + _LOOK, side="right")) - 1)
    start, stop = float(s[first]), float(s[last])
    if len(before) and len(after):
        pairs = np.argwhere(_crossing(border, before, after))
        if len(pairs):
            near = pairs[(pairs[:, 1] - pairs[:, 0]).argmin()]
            start, stop = float(s[before[near[0]]]), float(s[after[near[1]] + 1])
    return start - _MARGIN, stop + _MARGIN


def _crossing(line: Floats, before: np.ndarray, after: np.ndarray) -> Booleans:
    """(n, m) which of the steps `before` (n,) of a line cross which of those `after` (m,)."""
    a, b = line[before][:, None], line[before + 1][:, None]
    c, d = line[after][None], line[after + 1][None]
    apart = cross(b - a, c - a) * cross(b - a, d - a)
    across = cross(d - c, a - c) * cross(d - c, b - c)
    return np.asarray((apart <= 0.0) & (across <= 0.0))
