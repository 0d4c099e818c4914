"""Roads drawn as dashes or dots: those that follow each other are joined."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from roadlang.geometry import Booleans, Floats

from ..colors.tones import Layer

_LEAST, _MOST, _CHAIN = 8, 2000, 5
"""A picture of dashes has between `_LEAST` and `_MOST` of them; a chain has at least `_CHAIN`."""
_MAINLY = 0.6
"""Least share of the drawn surface that is dashes."""
_ALIKE = 2.5
"""Maximum factor between the area of a dash and the median area."""
_SOLID = 0.85
"""Least share of its convex hull that a dash fills; letters fill less."""
_LONG, _DOT = 1.6, 0.03
"""A dash is at least `_LONG` times as long as it is thick; a dot is at most `_DOT` of the picture's
side."""
_GAP, _AHEAD, _ON = 1.6, 0.6, -0.35
"""The gap between two dashes is at most `_GAP` times their length. The cosine between a dash and
the way to the next one is at least `_AHEAD`, and that between the ways to the previous and to the
next one at most `_ON`."""


@dataclass(frozen=True)
class _Dash:
    """Where its two ends are (2, 2), pixels, and the way from one to the other (2,), zero for a
    dot; its length and thickness in pixels."""

    ends: Floats
    ahead: Floats
    length: float
    thick: float


def with_dashes_joined(surface: Layer) -> Layer:
    """The surface (h, w), 0..1, with dashes joined; itself if it does not consist of dashes."""
    mask = surface >= 0.5
    seen, _ = cv2.findContours(mask.view(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    outlines = [np.asarray(outline, np.int32) for outline in seen]
    if not _LEAST <= len(outlines) <= _MOST:
        return surface
    areas = np.array([_area(outline, outline) for outline in outlines])
    usual = float(np.median(areas))
    alike = (areas < _ALIKE * usual) & (areas > usual / _ALIKE)
    if areas[alike].sum() < _MAINLY * areas.sum():
        return surface
    shapes = [outlines[index] for index in np.flatnonzero(alike)]
    dashes = [dash for shape in shapes for dash in _dash(shape, mask)]
    if len(dashes) < _CHAIN:
        return surface
    links = _chained(_links(dashes), len(dashes))
    if not links:
        return surface
    thick = max(1, round(float(np.median([dash.thick for dash in dashes]))))
    joined = np.zeros(mask.shape, np.uint8)
    for (a, end_a), (b, end_b) in links:
        way = np.round(np.array([dashes[a].ends[end_a], dashes[b].ends[end_b]]) * 16)
        cv2.polylines(joined, [way.astype(np.int32)], False, 1, thick, cv2.LINE_8, 4)
    return np.asarray(np.maximum(surface, joined), np.float32)


def _area(shape: NDArray[np.int32], outline: NDArray[np.int32]) -> float:
    """Of a shape about the pixels of an outline (n, 1, 2), square pixels: half of each pixel of it
    is outside."""
    return float(cv2.contourArea(shape)) + len(outline) / 2 + 1


def _dash(outline: NDArray[np.int32], mask: Booleans) -> Iterator[_Dash]:
    """The dash that an outline (n, 1, 2) is, if it is one."""
    middle, sides, angle = cv2.minAreaRect(outline)
    thick, length = min(sides) + 1.0, max(sides) + 1.0
    hull = _area(np.asarray(cv2.convexHull(outline), np.int32), outline)
    long = length >= _LONG * thick
    if _area(outline, outline) < _SOLID * hull or not (long or thick <= _DOT * min(mask.shape)):
        return
    turn = np.radians(angle + (90 if sides[1] > sides[0] else 0))
    ahead = np.array([np.cos(turn), np.sin(turn)]) * long
    reach, center = ahead * (length - thick) / 2, np.array(middle)
    yield _Dash(np.array([center - reach, center + reach]), ahead, length, thick)


_End = tuple[int, int]


def _links(dashes: list[_Dash]) -> list[tuple[_End, _End]]:
    """Which ends (dash, end) follow each other, nearest first; each end once."""
    ends = np.concatenate([dash.ends for dash in dashes])
    most = np.array([_GAP * dash.length + dash.thick for dash in dashes])
    pairs = cKDTree(ends).query_pairs(float(most.max()), output_type="ndarray")
    apart = np.hypot(*(ends[pairs[:, 0]] - ends[pairs[:, 1]]).T)
    near = (apart <= most[pairs // 2].min(axis=1)) & (pairs[:, 0] // 2 != pairs[:, 1] // 2)
    order = np.lexsort((pairs[near][:, 1], pairs[near][:, 0], apart[near].round(3)))
    ways: dict[int, list[tuple[int, Floats]]] = {index: [] for index in range(len(dashes))}
    links = []
    for first, second in pairs[near][order].tolist():
        (a, i), (b, j) = divmod(first, 2), divmod(second, 2)
        way = ends[second] - ends[first]
        way = way / max(1e-9, float(np.hypot(*way)))
        if _goes_on(dashes[a], i, way, ways[a]) and _goes_on(dashes[b], j, -way, ways[b]):
            ways[a].append((i, way))
            ways[b].append((j, -way))
            links.append(((a, i), (b, j)))
    return links


def _goes_on(dash: _Dash, end: int, way: Floats, taken: list[tuple[int, Floats]]) -> bool:
    """Whether a way may leave a dash at one of its ends, given those that do already."""
    if not dash.ahead.any():
        return len(taken) < 2 and all(float(way @ other) < _ON for _, other in taken)
    outward = dash.ahead if end else -dash.ahead
    return float(way @ outward) > _AHEAD and all(other != end for other, _ in taken)


def _chained(links: list[tuple[_End, _End]], count: int) -> list[tuple[_End, _End]]:
    """Those of the links that are in chains of several dashes."""
    root = list(range(count))

    def find(key: int) -> int:
        while root[key] != key:
            key = root[key]
        return key

    for (a, _), (b, _) in links:
        root[find(a)] = find(b)
    sizes = np.bincount([find(key) for key in range(count)], minlength=1)
    return [link for link in links if sizes[find(link[0][0])] >= _CHAIN]
