"""How sure roads of photos are: from evidence to the share of length that is right."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import uniform_filter1d

from roadlang.geometry import Floats

from .drawn_confidence import connected_parts
from .found_network import FoundNetwork, FoundRoad

_EVIDENCE, _WIDE, _ALONE, _LEAST = 0.6, -0.45, -1.5, 0.4
"""Log odds of being right: for each log odd of the evidence, each ten pixels of width beyond
`_NARROW`, full doubt of what is alone, and without any of it. Fitted by half of 51 photos, 14 at
1 m/px and 13 of streets in towns, but for the third one, which was .8 there: all of them show
roads, and of pictures that show none a faint line is all that is found."""
_NARROW = 12.0
"""The middle of wider roads is less certain: cars, crowns and medians hide a side of it."""
_SHORT, _SIDE = 1.15, 512
"""A connected part of the network stands alone if its total length is below this many sides of the
picture; of a larger picture, only this many pixels of its side count."""
_CLEAR, _FAINT = 0.8, 0.5
"""Mean evidence from which on what is alone is not doubted, and at which it is doubted in full."""
_STRETCH = 15
"""Evidence counts over so many points of a road."""
_CERTAIN = 0.98
"""Evidence above this, or as far below a half, says no more."""


def calibrated(found: FoundNetwork, doubt_alone: bool) -> FoundNetwork:
    """The same roads with confidences that are about the share of their length that is right.

    Faint roads that join no network are seldom any: they are doubted more, if `doubt_alone`.
    """
    short = _SHORT * min(*found.mask.shape, _SIDE)
    doubts: dict[int, float] = {}
    for part in connected_parts(found.roads):
        lengths = np.array([road.length for road in part])
        total = max(float(lengths.sum()), 1e-9)
        mean = float(lengths @ [road.confidence for road in part]) / total
        faint = max(0.0, (_CLEAR - mean) / (_CLEAR - _FAINT))
        doubts.update((id(road), faint if doubt_alone and total < short else 0.0) for road in part)
    roads = tuple(_calibrated(road, doubts[id(road)]) for road in found.roads)
    return replace(found, roads=roads)


def _calibrated(road: FoundRoad, doubt: float) -> FoundRoad:
    width = float(np.median(road.widths))
    known = _LEAST + _WIDE * max(0.0, width - _NARROW) / 10 + _ALONE * doubt
    seen = road.confidences
    if seen is None:
        seen = np.full(len(road.points), road.confidence)
    evidence = uniform_filter1d(seen.astype(float), min(_STRETCH, len(seen)), mode="nearest")
    sure = 1 / (1 + np.exp(-(_EVIDENCE * _log_odds(evidence) + known)))
    return replace(road, confidence=round(float(sure.mean()), 4), confidences=sure)


def _log_odds(evidence: Floats) -> Floats:
    share = np.clip(evidence, 1 - _CERTAIN, _CERTAIN)
    return np.asarray(np.log(share / (1 - share)))
