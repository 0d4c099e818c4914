"""Roads of drawings: a filled road, or the paper between two edge lines as in circuit plans."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image, Layer, away_from, layers, tones, without_other_colors
from ..masks.ellipses import closed_by
from ..masks.mask_parts import areas_of, parts_of, window_around, without_specks
from ..masks.skeleton import skeleton
from ..networks.found_network import EDGE_LINES, FoundNetwork
from .dashed_roads import with_dashes_joined
from .long_lines import long_lines
from .loose_strokes import are_loose
from .objects_on_roads import with_objects
from .open_edges import with_closed_ends
from .road_markings import with_markings_filled
from .road_regions import PaperParts, RoadRegion, road_regions
from .surface_roads import roads_of_surface

_BOLD, _THIN, _SOME = 3.5, 0.6, 0.03
"""Where edge lines are at least `_BOLD` pixels thick, lines thinner than `_THIN` of that are no
edges. They are removed where they are at least `_SOME` of the ink."""
_GAPS = (2, 4, 8)
"""Gaps in edge lines are closed by this many pixels from both sides, smallest first."""
_THICKER = 2.0
"""Closing has gone too far where strokes become this many times as thick as the pen: lines of text
then become blots."""
_SAMPLE = 50_000
"""Number of pixels, about, from which the thickness of a surface is estimated."""


def roads_of_drawing(image: Image, width: float | None = None) -> FoundNetwork:
    """The roads of a clean drawing; says in `method` which manner of drawing it took it for."""
    plan = tones(image)
    paper = plan.colors[plan.paper]
    others = np.delete(plan.colors, plan.paper, axis=0)
    ink = _ink(image, paper)
    if not ink.any():
        empty = np.zeros(image.shape[:2], bool)
        return FoundNetwork(np.zeros((0, 2)), (), empty, "drawing", ("the picture has one color",))
    between = between_lines(ink >= 0.5)
    if between is not None:
        found = roads_of_surface(between, EDGE_LINES, width=width)
        return replace(found, mask=between >= 0.5)
    shares = layers(image, list(others), paper)
    best = most_like_roads([*shares, ink] if len(others) != 1 else shares)
    for i, one in enumerate(shares):
        if one is best:
            best = without_other_colors(
                one, image, others[i], np.vstack([paper, *_rest(others, i)])
            )
    best = with_markings_filled(best, image)
    covered = with_objects(best, ink >= 0.5)
    if covered is not best:  # lines that ended at an object lie within the road now
        best = with_markings_filled(covered, image)
    best = with_dashes_joined(best)
    return roads_of_surface(best, "filled road", width=width)


def _ink(image: Image, paper: NDArray[np.float64]) -> Layer:
    """How far each pixel is from the paper, 0 (paper) to 1 (full ink)."""
    away = away_from(image, paper).astype(np.float32)
    marked = away[away > 30]
    if not len(marked):
        return np.zeros(image.shape[:2], np.float32)
    return np.asarray(np.clip(away / np.quantile(marked, 0.9), 0, 1))


def _rest(others: NDArray[np.float64], index: int) -> list[NDArray[np.float64]]:
    return [tone for i, tone in enumerate(others) if i != index]


def most_like_roads(surfaces: Sequence[Layer]) -> Layer:
    """The surface (h, w) that looks most like roads; of those that are as much like them as can be,
    the one that hangs together most: not the blocks of a town between its streets."""
    likenesses = [likeness(surface) for surface in surfaces]
    best = [s for s, value in zip(surfaces, likenesses, strict=True) if value == max(likenesses)]
    return best[0] if len(best) == 1 else max(best, key=_largest_share)


def _largest_share(surface: Layer) -> float:
    """The share of a surface (h, w) that is in its largest connected part."""
    count, labels = parts_of(surface >= 0.5)
    areas = areas_of(labels, count)[1:]
    return float(areas.max(initial=0) / max(1, areas.sum()))


def likeness(surface: Layer) -> float:
    """How much a surface (h, w) looks like roads: long, of even width, not too little.

    What reaches the border of the picture may have its middle beyond it: then most of its pixels
    are farther from its edge than its ridge says.
    """
    mask = without_specks(surface >= 0.5, 12)
    if not mask.any():
        return 0.0
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    ridge = inner[(inner >= cv2.dilate(inner, np.ones((3, 3)))) & mask]
    depths = inner[mask]
    depths = depths[:: max(1, len(depths) // _SAMPLE)]
    width = 2 * float(max(np.quantile(ridge, 0.9), np.quantile(depths, 0.9)))
    length = float(np.count_nonzero(mask)) / max(width, 1.0)
    return float(min(length / max(width, 1.0), 40.0) * min(1.0, length / max(mask.shape)))


def between_lines(ink: Booleans) -> Layer | None:
    """The surface (h, w) between two thin edge lines, up to their middles; None if there is none.

    Lines with gaps are closed by the least that makes the road a region of its own.
    """
    ribbons, ink = _between(ink)
    if not ribbons:
        return None
    return _surface(
        ribbons, ink, float(np.count_nonzero(ink) / max(1, int(np.count_nonzero(skeleton(ink)))))
    )


def has_edge_lines(ink: Booleans) -> bool:
    """Whether there are roads between thin lines (h, w)."""
    return bool(_between(ink)[0])


def has_long_edge_lines(ink: Booleans) -> bool:
    """Whether there are roads between the long lines (h, w), but for names and a frame."""
    long = long_lines(ink)
    return long is not None and bool(_between_all(long, _pen_width(ink)))


def _between(ink: Booleans) -> tuple[list[RoadRegion], Booleans]:
    """The regions between edge lines, and the ink (h, w) that these are of."""
    pen = _pen_width(ink)
    if pen > 0.02 * min(ink.shape) + 3:
        return [], ink
    ribbons = _between_all(ink, pen)
    if ribbons:
        return ribbons, ink
    bold = _without_thin_lines(ink, pen)
    if bold is not None:
        return _between(bold)
    long = long_lines(ink)
    return ([], ink) if long is None else (_between_all(long, pen), long)


def _between_all(ink: Booleans, pen: float) -> list[RoadRegion]:
    """The regions between all lines of the ink (h, w): as they are, or else with gaps closed, or
    else with open ends closed."""
    parts = PaperParts.about(ink)
    ribbons = road_regions(ink, parts)
    if ribbons and _edged(ribbons, ink, pen):
        return ribbons
    for closed, closed_parts in _closed_gaps(ink, parts):
        ribbons = road_regions(closed, closed_parts)
        if ribbons and _edged(ribbons, ink, pen) and _pen_width(closed) <= _THICKER * pen + 1:
            return ribbons
    capped = with_closed_ends(ink, pen)
    ribbons = [] if capped is None else road_regions(capped)
    return ribbons if ribbons and _edged(ribbons, ink, pen) else []


def _without_thin_lines(ink: Booleans, pen: float) -> Booleans | None:
    """The ink without lines thinner than most, such as dimensions and names; None if it has few."""
    if pen < _BOLD:
        return None
    size = 2 * int(_THIN * pen / 2) + 1  # odd: OpenCV moves what an even kernel opens
    bold = cv2.morphologyEx(ink.view(np.uint8), cv2.MORPH_OPEN, np.ones((size, size), np.uint8)) > 0
    bold = without_specks(bold, (3 * pen) ** 2)
    thin = np.count_nonzero(ink & ~bold)
    return bold if bold.any() and thin > _SOME * np.count_nonzero(ink) else None


def _closed_gaps(ink: Booleans, parts: PaperParts) -> Iterator[tuple[Booleans, PaperParts]]:
    """The ink with gaps closed, from small to wide, where that divides the `parts` of the paper,
    and its parts then."""
    widest = _closed(ink, _GAPS[-1])
    widest_parts = PaperParts.about(widest)
    if widest_parts.divides_as(parts):  # and so do all that are less wide
        return
    before = parts
    for gap in _GAPS[:-1]:
        closed = _closed(ink, gap)
        parts = PaperParts.about(closed)
        if not parts.divides_as(before):
            yield closed, parts
        before = parts
    if not widest_parts.divides_as(before):
        yield widest, widest_parts


def _closed(ink: Booleans, gap: int) -> Booleans:
    return closed_by(ink, 2 * gap + 1)


def _edged(ribbons: list[RoadRegion], ink: Booleans, pen: float) -> bool:
    """Whether the ink is mostly the edge of the ribbons: not so between two filled roads."""
    if pen > 0.6 * max(ribbon.width for ribbon in ribbons):
        return False
    union = _union(ribbons, ink.shape)
    near = cv2.distanceTransform(1 - union, cv2.DIST_L2, 5) <= pen + 2
    return bool(near[ink].mean() > 0.5) and not are_loose(ink, union, pen)


def _union(ribbons: list[RoadRegion], shape: tuple[int, ...]) -> NDArray[np.uint8]:
    union = np.zeros(shape, np.uint8)
    for ribbon in ribbons:
        union[ribbon.window] |= ribbon.part.astype(np.uint8)
    return union


def _pen_width(ink: Booleans) -> float:
    """Usual thickness of the ink."""
    inner = cv2.distanceTransform(ink.astype(np.uint8), cv2.DIST_L2, 5)
    ridge = inner[(inner >= cv2.dilate(inner, np.ones((3, 3)))) & ink]
    return 2 * float(np.quantile(ridge, 0.7)) - 1 if len(ridge) else np.inf


def _surface(ribbons: list[RoadRegion], ink: Booleans, pen: float) -> Layer:
    """The ribbons grown to the middle of the lines around them; thin lines across them vanish."""
    union = _union(ribbons, ink.shape)
    if len(ribbons) > 1:
        size = 2 * int(np.ceil(pen + 1)) + 1
        closed = cv2.morphologyEx(union, cv2.MORPH_CLOSE, np.ones((size, size), np.uint8))
        union |= closed & ink.astype(np.uint8)
    surface = np.zeros(ink.shape, np.float32)
    window = window_around(union, int(pen / 2) + 3)
    union = np.ascontiguousarray(union[window])
    outside = cv2.distanceTransform(1 - union, cv2.DIST_L2, 5)
    inside = cv2.distanceTransform(union, cv2.DIST_L2, 5)
    signed = np.where(union > 0, inside - 0.5, 0.5 - outside) + pen / 2
    surface[window] = np.clip(0.5 + signed, 0, 1)
    return surface
