"""Whether a picture of flat colors is a rendered map, or a drawing of few colors."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..drawings.road_markings import with_markings_filled
from .map_lines import THIN
from .map_tones import MapTone, map_tone
from .street_names import streets_below_names

LETTERED = 0.003
"""Least share of a map of few colors that letters cover."""
FEW = 3
"""Maximum number of colors of a picture of few colors."""
_MANY = 6
"""More colors are a map's."""
_PALE = 40.0
"""If the roads differ from the land by fewer gray levels, a picture of few colors is not a
drawing."""
_PLAIN = 0.9
"""Share of a drawing that is its ground or its roads."""
_BESIDE = 0.1
"""Names are on the roads of a map or beside them: at least this share of them is within one width
of a road."""
_ON_STREETS = 0.05
"""Least share of the names of a map with streets below them."""
_MARKED = 0.02
"""Least share of the roads of a drawing that markings on them cover."""
_EVEN = 0.9
"""With their markings filled, roads keep their width on at least as much of their length as
without, or on `_EVEN` of it: a gap between a house and a river in the color of the streets is no
marking."""
_MOSTLY = 0.5
"""Lines are markings if more than this share of them is within roads."""
_WHOLE, _TIMES, _ENCLOSED = 0.35, 3.0, 0.6
"""Drawn roads, with their markings filled, keep their width on at least `_WHOLE` of their surface,
are at least `_TIMES` as wide as a line on them, and surround more than `_ENCLOSED` of it."""
_GRAY = np.array([0.114, 0.587, 0.299])


def is_drawing(
    tones: Sequence[MapTone],
    roads: Sequence[MapTone],
    letters: Booleans,
    colors: int,
    is_named: Callable[[], bool],
) -> bool:
    """Whether what has so many `colors`, of which some `tones` are the roads', and `letters`
    (h, w), is rather a drawing; `is_named` is what `are_named` says of these.

    Few colors without names are one, but for roads as light as the land within casings. So are
    roads of one color on a plain ground, of which no names are, or which have markings, unless they
    are interrupted by names.
    """
    if colors > _MANY:
        return False
    # All of a tone: of one that streets share with houses, the roads may be a part.
    roads = [tone for tone in tones if any(np.array_equal(tone.color, r.color) for r in roads)]
    land = max(tones, key=lambda tone: np.count_nonzero(tone.mask))
    covered = np.logical_or.reduce([land.mask, *(road.mask for road in roads)])
    plain = float(np.count_nonzero(covered)) / covered.size
    if colors <= FEW and np.count_nonzero(letters) < LETTERED * letters.size:
        pale = all(abs(float((tone.color - land.color) @ _GRAY)) < _PALE for tone in roads)
        return not pale or plain < _PLAIN
    if _are_markings(land, roads):
        return True
    if len(roads) != 1 or plain < _PLAIN or is_named():
        return False
    return _names_nothing(roads[0], letters) or _is_marked(roads[0])


def are_named(streets: Sequence[MapTone], letters: Booleans) -> bool:
    """Whether `streets` lead up to the names that are written on them (h, w): a drawing, or a plan,
    interrupts no road for its name."""
    surface = np.logical_or.reduce([tone.mask for tone in streets])
    below, _ = streets_below_names(surface, letters, streets[0].width)
    return bool(np.count_nonzero(below & letters) > _ON_STREETS * np.count_nonzero(letters))


def _names_nothing(road: MapTone, letters: Booleans) -> bool:
    side = 2 * int(np.ceil(road.width)) + 1
    near = cv2.dilate(road.mask.astype(np.uint8), np.ones((side, side), np.uint8)) > 0
    return bool(np.count_nonzero(letters & near) < _BESIDE * np.count_nonzero(letters))


def _are_markings(land: MapTone, roads: Sequence[MapTone]) -> bool:
    """Whether most of what was taken for roads, or one color of it, is painted on a wide road."""
    drawn = ~land.mask
    lines = np.logical_or.reduce([road.mask for road in roads])
    filled = with_markings_filled((drawn & ~lines).astype(np.float32)) >= 0.5
    are_filled = bool(np.count_nonzero(filled & lines) > _MOSTLY * np.count_nonzero(lines))
    enclosed = [] if are_filled else [road for road in roads if _within(road, drawn)]
    if not (are_filled or enclosed):
        return False
    # To measure what is drawn takes longer than all else.
    whole = map_tone(land.color, drawn)
    return whole.steady >= _WHOLE and (
        are_filled or any(_TIMES * road.width <= whole.width for road in enclosed)
    )


def _within(line: MapTone, drawn: Booleans) -> bool:
    """Whether all that is drawn (h, w) goes on at both sides of most of a line."""
    lines = line.mask.astype(np.uint8)
    near, far = (cv2.dilate(lines, np.ones((side, side), np.uint8)) > 0 for side in (5, 9))
    return bool(drawn[far & ~near].mean() > _ENCLOSED)


def _is_marked(road: MapTone) -> bool:
    if road.width < THIN:
        return False
    filled = with_markings_filled(road.mask.astype(np.float32)) >= 0.5
    if filled.sum() - road.mask.sum() <= _MARKED * road.mask.sum():
        return False
    return map_tone(road.color, filled).even >= min(road.even, _EVEN)
