"""How sure roads of photos are: from evidence to the share of length that is right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import uniform_filter1d

from roadlang.geometry import Floats

from ..doubts.upright_patterns import is_upright_pattern
from ..networks.connected_roads import connected_parts
from ..networks.found_network import NO_ROAD, FoundNetwork, FoundRoad

_LEAST, _EVIDENCE, _WIDE = 0.899, 0.449, -0.334
"""Log odds of being right: without anything, for each log odd of the evidence, and for each ten
pixels of width beyond `_NARROW`. `python -m benchmarks.extraction.confidence` fits them; these are
of 26 photos at 1 m/px and 25 of towns."""
_ONLY = -2.2
"""For full doubt: of what is alone where the picture shows nothing else, and of all roads where all
are faint. Not fitted, for those photos show roads: in a picture without them, lines are faint. It
is large enough that a single clear stretch is not sure, and so small that roads below a half are
right as often as stated, within .05."""
_NARROW = 12.0
"""The middle of wider roads is less certain: cars, crowns and medians hide a side of it."""
_SHORT, _SIDE = 1.15, 512
"""A picture shows nothing else if the total length of its roads is below this many sides of it; of
a larger picture, only this many pixels of its side count."""
_CLEAR, _FAINT = 0.8, 0.5
"""Mean evidence from which on what is alone is not doubted, and at which it is doubted in full."""
_CLEAR_IN_ALL, _FAINT_IN_ALL = 0.66, 0.52
"""The same for all roads of a picture: of 36 photos with roads, two were below the second one, both
wrong on more than half of the length that was found."""
_PALE, _VIVID, _HAZE, _BETWEEN = 0.10, 0.20, 3.0, 0.06
"""The clearer the colors, the clearer the roads have to be. All are doubted in full if their mean
evidence is at most `_PALE` + `_VIVID` log(`_HAZE` + chroma), and not at all if it is more than
`_BETWEEN` above that. Of 52 pictures without roads that had been sure, 27 no longer are; of 293
photos and renderings with roads 3: two of desert, one in infrared light."""
CHROMA = "chroma"
"""The score of a network of a photo that says how colored it is."""
_MANY, _MEET = 8, 0.1
"""So many roads or more are rows, such as waves in sand, if they have fewer junctions than this
share of their number: then all are doubted in full."""
_STRETCH = 15
"""Evidence counts over so many points of a road."""
_CERTAIN = 0.98
"""Evidence above this, or as far below a half, says no more."""


@dataclass(frozen=True)
class RoadFacts:
    """What the confidence of a road depends on.

    `evidence` (n,) are log odds at its points, `wide` tens of pixels of width beyond 12, `given`
    further log odds: of a faint road that joins no network where the picture shows nothing else, or
    of all roads where all are faint.
    """

    evidence: Floats
    wide: float
    given: float = 0.0


def calibrated(found: FoundNetwork, doubt_alone: bool) -> FoundNetwork:
    """The same roads with confidences that are about the share of their length that is right.

    Faint roads in a picture that shows little else, or none that are clearer, are seldom any: they
    are doubted more, if `doubt_alone`, and so are patterns such as bricks.
    """
    facts = road_facts(found, doubt_alone)
    roads = tuple(_calibrated(*pair) for pair in zip(found.roads, facts, strict=True))
    if doubt_alone and is_upright_pattern(roads):
        roads = tuple(road.less_sure(NO_ROAD) for road in roads)
    return replace(found, roads=roads)


def road_facts(found: FoundNetwork, doubt_alone: bool = True) -> list[RoadFacts]:
    """Of each road, in order; its `confidences` are the evidence along it."""
    short = _SHORT * min(*found.mask.shape, _SIDE)
    little = doubt_alone and sum(road.length for road in found.roads) < short
    doubts = _doubts(found) if little else {}
    of_all = _doubt_of_all(found) if doubt_alone else 0.0
    return [
        RoadFacts(
            _evidence(road),
            max(0.0, road.usual_width - _NARROW) / 10,
            _ONLY * max(of_all, doubts.get(id(road), 0.0)),
        )
        for road in found.roads
    ]


def _doubts(found: FoundNetwork) -> dict[int, float]:
    """How doubtful each road is, 0 to 1, by the evidence of all that it is connected to."""
    doubts: dict[int, float] = {}
    for part in connected_parts(found.roads):
        doubt = _doubt(part, _CLEAR, _FAINT)
        doubts.update((id(road), doubt) for road in part)
    return doubts


def _doubt_of_all(found: FoundNetwork) -> float:
    """How doubtful all roads of a picture are, 0 to 1, by their evidence, the colors of the picture
    and how few roads meet."""
    roads = found.roads
    nodes = np.array([(road.start, road.end) for road in roads], np.intp)
    junctions = np.count_nonzero(np.bincount(nodes.ravel()) > 2)
    if len(roads) >= _MANY and junctions < _MEET * len(roads):
        return 1.0
    vivid = _PALE + _VIVID * float(np.log(_HAZE + found.scores.get(CHROMA, 0.0)))
    faint = max(_FAINT_IN_ALL, vivid)
    return _doubt(roads, max(_CLEAR_IN_ALL, faint + _BETWEEN), faint)


def _doubt(roads: Sequence[FoundRoad], clear: float, faint: float) -> float:
    """How doubtful roads are, 0 to 1, by their mean evidence from `clear` to `faint`."""
    lengths = np.array([road.length for road in roads])
    known = float(lengths @ np.array([road.confidence for road in roads]))
    mean = known / max(float(lengths.sum()), 1e-9)
    return float(np.clip((clear - mean) / (clear - faint), 0.0, 1.0))


def _evidence(road: FoundRoad) -> Floats:
    seen = road.confidences
    if seen is None:
        seen = np.full(len(road.points), road.confidence)
    even = uniform_filter1d(seen.astype(float), min(_STRETCH, len(seen)), mode="nearest")
    share = np.clip(even, 1 - _CERTAIN, _CERTAIN)
    return np.asarray(np.log(share / (1 - share)))


def _calibrated(road: FoundRoad, facts: RoadFacts) -> FoundRoad:
    known = _LEAST + _WIDE * facts.wide + facts.given
    sure = 1 / (1 + np.exp(-(_EVIDENCE * facts.evidence + known)))
    return replace(road, confidence=round(float(sure.mean()), 4), confidences=sure)
