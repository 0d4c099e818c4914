"""How sure the roads of a drawing are: what is drawn is there, but it may be letters or blots."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..networks.connected_roads import connected_parts
from ..networks.found_network import EDGE_LINES, NO_ROAD, FoundNetwork, FoundRoad
from .box_lines import are_boxes, are_framed
from .explained_surface import ExplainedSurface
from .line_art import ends_at_rim, sure_by_junctions, sure_by_widths
from .road_likeness import sure_by_likeness, sure_like_map

_LONG, _SLENDER = 0.6, 3.0
"""Connected roads have full confidence if their total length is at least `_LONG` shorter sides
of the picture, and each is at least `_SLENDER` widths long. That of others is lowered in
proportion."""
_MANY, _MOSTLY = 6, 0.7
"""A drawing with at least `_MANY` connected parts is text unless at least `_MOSTLY` of the total
length is in long parts. The confidence of all is lowered in proportion, also of parts that leave
the picture."""
_FOLDED, _REACH = 3.5, 0.3
"""Roads more than `_FOLDED` times as long as their extent (a ring has less) are a scribble if their
extent is below `_REACH` shorter sides; their confidence is lowered in proportion."""
_EXPLAINED, _EXPLAINED_EDGED = (0.7, 0.9), (0.85, 0.97)
"""Roads are as wide as measured on the second share of their surface or more; with the first share
or less, as on a chessboard, it consists of no roads. Two edge lines say more closely where a road
is: what lies between other lines, such as arrows and connectors, widens here and there."""
_GROUND = 0.6
"""A part that covers more than this share of the picture's rim is the ground around a drawing, not
a road."""
_ROWS, _EVEN = 3, 0.02
"""At least `_ROWS` separate lines that are all horizontal or all vertical, with both ends within
the picture, are rows, columns or fields. Such a line deviates sideways by at most `_EVEN` of its
length."""
_SCATTERED, _LONG_PART = 4, 0.3
"""At least `_SCATTERED` separate parts that do not leave the picture, each at least `_LONG_PART`
shorter sides long, are figures: roads lead somewhere."""
_STRIPES, _PARALLEL, _NEARLY = 6, 0.05, 0.95
"""At least `_STRIPES` lines, each alone, are stripes if the chords of those that have a common
direction, within `_PARALLEL` radians, are at least `_NEARLY` of the length of all."""
OPEN = 2
"""More roads than this leave a map."""
_ALONG, _TOUCHING = 0.7, 1.5
"""A bar is within `_TOUCHING` pixels of the border along at least `_ALONG` of its length."""
_STATED = ("legend", "free space")
"""The methods by which somebody said which colors are roads: what they say is no line art."""


def with_doubts(found: FoundNetwork, drawn: bool = True, measured: bool = True) -> FoundNetwork:
    """The same roads, those less sure that are short, alone, hardly longer than wide, or the
    ground; and, if they were `drawn` and not rendered as a map, what is a box, a row or a curve of
    a chart, or leaves its surface unexplained.

    A map goes on beyond the picture: what hardly any road leaves was drawn. `measured`: whether the
    widths of the roads are those that were seen.
    """
    side = min(found.mask.shape)
    factors: dict[int, float] = {}
    parts = connected_parts(found.roads)
    mostly = _share_in_long(parts, _LONG * side) if len(parts) >= _MANY else 1.0
    bars = [all(_is_bar(road, found.mask.shape) for road in part) for part in parts]
    exits = [sum(int(ends_at_rim(x, found.mask.shape).sum()) for x in part) for part in parts]
    leaving = [count > 0 for count in exits]
    colored, drawn = not drawn, drawn or sum(exits) <= OPEN
    network = _sure_as_network(found, drawn, colored)
    surface = ExplainedSurface.of(found.mask, found.roads, measured)
    inside = [drawn and not leaves for leaves in leaving]
    rows = _rows(parts, inside)
    figures = _scattered(parts, inside, side) if found.method not in _STATED else rows
    shares = [surface.shares(part) for part in parts]
    nothing, sure = _EXPLAINED_EDGED if found.method == EDGE_LINES else _EXPLAINED
    boxes = [drawn and are_boxes(part, side) for part in parts]
    frames = [part for part, is_box in zip(parts, boxes, strict=True) if is_box]
    # The paper within a frame is as little a road as the paper around it.
    is_ground = drawn and any(rim > _GROUND for _, rim in shares)
    is_ground |= drawn and _are_stripes(parts)
    for index, part in enumerate(parts):
        explained, rim = shares[index]
        alone = mostly < _MOSTLY or not leaving[index]
        factor = _slender(part) * (_extended(part, side) if alone else 1.0)
        factor *= min(1.0, mostly / _MOSTLY) * network
        is_none = bars[index] and (drawn or all(bars))
        is_none |= rows[index] or figures[index] or boxes[index] or is_ground or rim > _GROUND
        if drawn:
            factor *= float(np.clip((explained - nothing) / (sure - nothing), 0.0, 1.0))
            is_none |= are_framed(part, frames, side)
        factor *= NO_ROAD if is_none else 1.0
        factors.update((id(road), factor) for road in part)
    roads = tuple(road.less_sure(factors[id(road)]) for road in found.roads)
    return replace(found, roads=roads)


def _sure_as_network(found: FoundNetwork, drawn: bool, colored: bool) -> float:
    """How sure all roads are by how they meet, leave the picture and are like roads and, if drawn,
    keep their width; what a rendered map shows is wide at its symbols."""
    if not found.roads or found.method in _STATED:
        return 1.0
    sure = sure_by_junctions(found.roads, found.mask.shape)
    if colored:
        sure = min(sure, sure_like_map(found))
    if not drawn:
        return sure
    by_widths = sure_by_widths(found.roads, min(found.mask.shape))
    return min(sure, by_widths, sure_by_likeness(found, colored))


def _rows(parts: list[list[FoundRoad]], inside: list[bool]) -> list[bool]:
    """Which parts are rows, columns or fields, as of a table or a form, of those that end `inside`
    the picture."""
    level = [_level(part) if ends else 0 for part, ends in zip(parts, inside, strict=True)]
    many = [way for way in (1, 2) if level.count(way) >= _ROWS]
    return [way in many for way in level]


def _are_stripes(parts: list[list[FoundRoad]]) -> bool:
    """Whether hardly anything but straight parallel lines was found, which never meet."""
    if len(parts) < _STRIPES or any(len(part) > 1 for part in parts):
        return False
    chords = np.array([part[0].points[-1] - part[0].points[0] for part in parts])
    long = np.hypot(*chords.T)
    # Twice the angle is the same in both directions of a line.
    twice = 2 * np.arctan2(chords[:, 1], chords[:, 0])
    common = np.angle((long * np.exp(1j * twice)).sum())
    alike = np.abs(np.angle(np.exp(1j * (twice - common)))) <= 2 * _PARALLEL
    return bool(long[alike].sum() >= _NEARLY * sum(part[0].length for part in parts))


def _scattered(parts: list[list[FoundRoad]], inside: list[bool], side: int) -> list[bool]:
    """Which parts are figures scattered over the picture, each alone, of those as in `_rows`."""
    alone = [
        ends and sum(road.length for road in part) >= _LONG_PART * side
        for part, ends in zip(parts, inside, strict=True)
    ]
    return alone if sum(alone) >= _SCATTERED else [False] * len(parts)


def _level(part: list[FoundRoad]) -> int:
    """1 for a straight line that is level, 2 for an upright one, 0 for all else."""
    corners = np.concatenate([[r.points.min(axis=0), r.points.max(axis=0)] for r in part])
    reach = np.ptp(corners, axis=0)
    if reach.min() > _EVEN * reach.max():
        return 0
    return 1 + int(reach.argmax())


def _slender(part: list[FoundRoad]) -> float:
    """How sure roads that hang together are by their length over their width."""
    lengths = np.array([road.length for road in part])
    widths = np.array([road.usual_width for road in part])
    slender = float((lengths**2).sum() / max(float(lengths @ widths), 1e-9))
    return min(1.0, slender / _SLENDER)


def _extended(part: list[FoundRoad], side: int) -> float:
    """How sure they are by their length in all, and by how far they reach: a scribble is long."""
    total = max(sum(road.length for road in part), 1e-9)
    corners = np.concatenate([[r.points.min(axis=0), r.points.max(axis=0)] for r in part])
    reach = float(np.ptp(corners, axis=0).max())
    long = min(1.0, total / side / _LONG)
    return long if total < _FOLDED * reach else min(long, reach / side / _REACH)


def _is_bar(road: FoundRoad, shape: tuple[int, ...]) -> bool:
    """Whether a road lies along the border of the picture (h, w), as the bar of a window does."""
    near = _TOUCHING + 0.5 * road.usual_width
    last = np.array(shape[::-1]) - 1
    off = np.minimum(road.points, last - road.points)
    return bool(max((off <= near).mean(axis=0)) > _ALONG)


def _share_in_long(parts: list[list[FoundRoad]], least: float) -> float:
    """The share of the length that is in parts of at least so many pixels."""
    lengths = np.array([sum(road.length for road in part) for part in parts])
    return float(lengths[lengths >= least].sum() / max(float(lengths.sum()), 1e-9))
