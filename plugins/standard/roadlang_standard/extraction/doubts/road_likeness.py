"""How much the network of a drawing is like roads, by what a logistic model weighs: diagrams, faces
and cracks are thin, wind tightly, fork sharply, seldom leave the picture, and vary in width.

No single one of these tells: streets are thin as well, and a town may end within the picture.
`python -m benchmarks.extraction.likeness` fits the weights of drawings.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roadlang.geometry import Floats

from ..curves.smoothing import resample
from ..networks.connected_roads import connected_parts
from ..networks.found_network import NO_ROAD, FoundNetwork, FoundRoad
from .box_lines import upright_share
from .fork_angles import sharp_forks
from .line_art import ends_at_rim

LIKENESS = {
    "always": 2.66,
    "thin": -1.41,
    "joins": -0.38,
    "crossings": -0.61,
    "exits": 1.39,
    "uneven": -14.59,
    "tight": -2.70,
    "straight": 0.63,
    "unlike": -3.93,
    "parts": -2.23,
    "upright": -0.47,
    "colored": -2.63,
    "winding": -0.13,
    "extent": 1.93,
    "forks": -0.97,
}
"""Log odds of being roads for each of what `likeness_facts` gives, fitted to 202 networks of
pictures without roads and 285 of drawings of roads, tests among them."""
_UNLIKELY, _LIKELY = -2.1, -1.2
"""Below the log odds `_UNLIKELY` roads have the confidence `NO_ROAD`; from `_LIKELY` on it is not
lowered. Of pictures left out of the fit, 5 of the 285 of roads are below, and 36 of the 69 others
that no other rule finds."""
MAP_LIKENESS = {
    "always": -0.72,
    "tight": -8.28,
    "uneven": -4.02,
    "upright": -4.13,
    "odd": -0.22,
    "straight": 3.15,
    "apart": -1.53,
    "extent": 2.40,
    "sharp": -1.66,
    "many": -0.24,
}
"""The same for maps, for each of what `map_facts` gives, fitted to 152 maps and
119 other pictures in which roads were found by color."""
_UNLIKE_MAP, _LIKE_MAP = -2.3, -2.0
"""As `_UNLIKELY` and `_LIKELY`. Of places and pictures left out of the fit, none of 144 maps that
are sure is below the second one (the lowest, a mat for toy cars, has -1.85), and 7 of 13 others
are: forms, screens, charts, pipes; a table cloth, the vessels of an eye and hands are not."""
_USUAL, _HAIR = 0.01, 1e-3
"""Usual and least width of streets on maps, as shares of the picture's shorter side."""
_SLIM = 0.015
"""Lines are thin below this share of the picture's shorter side."""
_BLOT = 3.0
"""Parts less than this many times as long as wide, such as parking lots, do not count when widths
are compared."""
_LEAST_WIDTH = 2.0
"""Turns are measured over steps of one width, and variation of the width relative to it; the width
counts as at least this many pixels."""
_TIGHT, _STRAIGHT = 0.35, 0.02
"""A line is tight where it turns by more than `_TIGHT` radians within one width, and straight where
it turns by less than `_STRAIGHT`."""


def sure_by_likeness(found: FoundNetwork, colored: bool) -> float:
    """How sure all roads of a drawing are by what they are like; see `likeness_facts`."""
    facts = likeness_facts(found, colored)
    odds = sum(weight * facts[name] for name, weight in LIKENESS.items())
    return float(np.interp(odds, (_UNLIKELY, _LIKELY), (NO_ROAD, 1.0)))


def sure_like_map(found: FoundNetwork) -> float:
    """How sure all roads of a map are by what they are like; see `map_facts`."""
    facts = map_facts(found)
    odds = sum(weight * facts[name] for name, weight in MAP_LIKENESS.items())
    return float(np.interp(odds, (_UNLIKE_MAP, _LIKE_MAP), (NO_ROAD, 1.0)))


def map_facts(found: FoundNetwork) -> dict[str, float]:
    """What tells the roads of a map from what else has even strips of a color, by the names of
    `MAP_LIKENESS`; as in `likeness_facts`, but `odd` is how far from the usual width they are,
    `apart` how many roads meet no other, `sharp` how many forks are sharp, `many` how many roads
    there are."""
    facts, count = likeness_facts(found, True), len(found.roads)
    widths = [road.usual_width for road in found.roads]
    width = float(np.median(widths)) / min(found.mask.shape)
    alike = ("always", "tight", "uneven", "upright", "straight", "extent")
    return {name: facts[name] for name in alike} | {
        "odd": float(np.log(max(width, _HAIR) / _USUAL)) ** 2,
        "apart": float(np.expm1(facts["parts"])) / count,
        "sharp": facts["forks"] / float(np.log1p(count)),
        "many": float(np.log(count)),
    }


def likeness_facts(found: FoundNetwork, colored: bool) -> dict[str, float]:
    """What tells roads, one or more, from other lines, by the names of `LIKENESS`. `colored`:
    whether they were found by colors, as those of a rendered map are."""
    roads = found.roads
    lengths = np.array([road.length for road in roads])
    widths = np.array([road.usual_width for road in roads])
    total = max(float(lengths.sum()), 1e-9)
    slender = np.where(lengths >= _BLOT * widths, lengths, 1e-9)
    usual = max(float(slender @ widths / slender.sum()), 1e-9)
    apart = np.log(np.maximum(widths, 0.5) / max(usual, 0.5))
    deviations = [
        np.std(road.widths) / max(float(np.mean(road.widths)), _LEAST_WIDTH) for road in roads
    ]
    nodes = np.array([(road.start, road.end) for road in roads], np.intp)
    degree = np.bincount(nodes.ravel())
    free = degree[nodes] == 1
    rim = np.array([ends_at_rim(road, found.mask.shape) for road in roads])
    turns, along = _turns(roads, widths)
    length = max(float(along.sum()), 1.0)
    points = np.concatenate([road.points for road in roads])
    extent = np.ptp(points, axis=0) / np.array(found.mask.shape[::-1])
    return {
        "always": 1.0,
        "thin": max(0.0, float(np.log(_SLIM * min(found.mask.shape) / usual))),
        "joins": float(np.log1p(np.count_nonzero(degree == 3))),
        "crossings": float(np.log1p(np.count_nonzero(degree > 3))),
        "exits": float(np.log1p(np.count_nonzero(free & rim))),
        "uneven": float(lengths @ np.array(deviations)) / total,
        "tight": float(along[turns > _TIGHT].sum()) / length,
        "straight": float(along[turns < _STRAIGHT].sum()) / length,
        "unlike": float(np.sqrt(slender @ apart**2 / slender.sum())),
        "parts": float(np.log1p(len(connected_parts(roads)))),
        "upright": upright_share(roads),
        "colored": float(colored),
        "winding": float(turns.sum()) / length * min(found.mask.shape),
        "extent": float(extent.min()),
        "forks": float(np.log1p(sharp_forks(roads, degree))),
    }


def _turns(roads: Sequence[FoundRoad], widths: Floats) -> tuple[Floats, Floats]:
    """By how many radians roads of these widths turn from one width to the next (n,), and how long
    each of these steps is (n,), pixels."""
    turns, along = [np.zeros(0)], [np.zeros(0)]
    for road, width in zip(roads, np.maximum(widths, _LEAST_WIDTH).tolist(), strict=True):
        across, down = np.diff(resample(road.points, width), axis=0).T
        change = np.diff(np.arctan2(down, across))
        turns.append(np.abs((change + np.pi) % (2 * np.pi) - np.pi))
        along.append(np.full(len(change), width))
    return np.concatenate(turns), np.concatenate(along)
