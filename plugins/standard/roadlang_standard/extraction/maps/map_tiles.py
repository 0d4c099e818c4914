"""Roads of rendered maps: the tones that are ribbons, joined beneath letters and signs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image, Layer
from ..drawings.surface_roads import Cover, roads_of_surface
from ..masks.ellipses import closed_by, grown_by
from ..masks.mask_parts import (
    opened_by_square,
    parts_and_boxes,
    parts_touching,
    where_parts,
    without_holes,
    without_specks,
)
from ..masks.skeleton import skeleton
from ..networks.found_network import FoundNetwork
from .map_contrast import stretch_of, without_strong_contrast
from .map_controls import without_controls
from .map_halos import are_written_alike, without_halos
from .map_letters import LARGER, letters_of_map, without_letters
from .map_lines import THIN, holes, short_parts, without_barbs
from .map_or_drawing import FEW, LETTERED, are_named, is_drawing
from .map_roads import MapRoads, chosen_roads
from .map_styles import MapStyle, gray_style_of, style_of
from .map_tones import (
    LOSSY,
    MapTone,
    Tolerance,
    color_masks,
    flat_colors,
    tolerance_of,
    without_jpeg_noise,
)
from .map_water import masks_without_water
from .road_tones import MOST_SPREAD
from .street_names import streets_below_names

_COLORS = 2
"""Least number of colors of a map. A picture with only this many is a map if it has letters,
otherwise a drawing."""
_THIN, _LONG = 0.5, 5.0
"""Parts narrower than `_THIN` of the usual width, or shorter than `_LONG` widths, are not roads."""
_WIDE = 2.6
"""Parts more than this many times as wide as the widest roads are squares or parking lots."""
_GAP, _LETTER_GAP, _HOLE = 0.35, 0.8, 1.5
"""Gaps in the surface are closed by `_GAP` widths to each side, below letters by `_LETTER_GAP`;
holes are filled up to `_HOLE` square widths."""
_ROAD, _LAND, _UNKNOWN = 0.25, 0.002, 0.6
"""Likelihood of a hidden road on visible road, on land, and below letters or casings. On road it is
low, so that a bridge between dead ends does not turn back along its own road."""
_NEAR = 4
"""Short parts in the color of a road belong to it within this many pixels of its other parts."""
_STROKE = 3
"""Half the greatest thickness of the strokes of letters, in pixels: remnants of a road between them
are part of it, although thinner than a road."""
_BESIDE, _LETTERS = 2, 7
"""Letters within `_BESIDE` pixels of houses in the color of letters do not count; of the rest,
those thinner than `_LETTERS` pixels do not."""
_OUTLINE = 0.7
"""Parts below the name of a street that are thinner than this share of the usual width are outlines
of the name."""
_EDGE = 3
"""Edges and casings are thinner than so many pixels."""
_ON_LETTERS = 0.6
"""A tone with at least this share on letters is their outline."""


def roads_of_map(
    image: Image, width: float | None = None, is_plan: Callable[[], bool] = lambda: False
) -> FoundNetwork | None:
    """The roads (pixels) of a rendered map (h, w, 3).

    None if the picture has too few colors for a map, if none of them looks like roads, or if it
    `is_plan`, which is asked before what takes longest.
    """
    tolerance = tolerance_of(image)
    plain = without_jpeg_noise(image) if tolerance is LOSSY else image
    plain = without_controls(plain, tolerance)
    names = letters_of_map(plain, LARGER)
    colors = flat_colors(plain, tolerance)
    style = style_of(plain, colors, tolerance)
    if style is None and tolerance is LOSSY:
        # In a lossless file, the shapes of the few grays tell more than the grays.
        style = gray_style_of(plain, colors)
    stretch = stretch_of(plain, tolerance, names, colors)
    clear = plain if stretch is None else stretch.picture(plain)
    if style is not None and stretch is not None:
        style = style.stretched(stretch)
    # Nobody draws with so little contrast as faint maps have.
    may_be_plan = is_plan if clear is plain else None
    if tolerance is LOSSY and clear is plain and style is None:
        clear = without_strong_contrast(plain, names, colors)
    return _roads_of_map(clear, _Seen(plain, names, colors, style), tolerance, width, may_be_plan)


@dataclass(frozen=True)
class _Seen:
    """A map (h, w, 3) before its contrast is changed, of which noise would become letters, what
    is written on it (h, w), as names on roads leave no even strips of their color, its flat colors,
    and its style, None if that is not known."""

    image: Image
    names: Booleans
    colors: list[NDArray[np.float64]]
    style: MapStyle | None

    def letters(self, width: float) -> Booleans:
        """What is written (h, w) where roads are usually so many pixels wide."""
        return self.names if width <= LARGER else letters_of_map(self.image, width)


def _roads_of_map(
    image: Image,
    seen: _Seen,
    tolerance: Tolerance,
    width: float | None,
    is_plan: Callable[[], bool] | None,
) -> FoundNetwork | None:
    plain = without_letters(image, seen.names)
    colors = seen.colors if plain is seen.image else flat_colors(plain, tolerance)
    style = seen.style
    if style is not None:
        colors = style.with_its_own(colors, tolerance)
    written = _differing(plain, image)
    if len(colors) < _COLORS or (len(colors) == _COLORS and written < LETTERED):
        return None
    chosen, thin = chosen_roads(plain, colors, tolerance, style)
    if not chosen.roads:
        return None
    usual = chosen.width(lambda tone: tone.width)
    typical = chosen.width(lambda tone: tone.typical_width) if thin else usual
    letters = seen.letters(typical)
    shown = [tone.color for tone in chosen.tones]
    if is_plan is not None and _is_drawn(chosen, letters, len(shown), is_plan):
        return None
    if plain is image and not thin:
        everything = [tone.mask for tone in chosen.all_tones]
        dry = [tone.mask for tone in chosen.tones]
    else:
        everything = color_masks(image, shown, tolerance.near, thin)
        dry = masks_without_water(shown, everything)
    mask, others = _masks(dry, chosen, letters, thin)
    if tolerance is LOSSY and thin:
        mask = without_barbs(mask)
    water = [one & ~land for one, land in zip(everything, dry, strict=True) if land is not one]
    others, letters = others + water, _beside(water, letters)
    widest = max(_wide(tone) for tone in chosen.roads)
    if not are_written_alike(image, letters, chosen.land.color, chosen.roads[0].color):
        mask = without_halos(mask, letters)
    surface, hidden = _uncovered(mask, others, letters, (usual, typical, widest))
    cover = Cover(letters, hidden, widest, drawn=len(shown) <= FEW and not thin)
    layer = surface.astype(np.float32)
    found = roads_of_surface(layer, "map", width=width, specks=usual**2, cover=cover)
    return replace(found, mask=surface)


def _beside(water: list[Booleans], letters: Booleans) -> Booleans:
    """The letters (h, w) without houses and water of their color (h, w)."""
    if not water:
        return letters
    return opened_by_square(letters & ~_grown(np.logical_or.reduce(water), _BESIDE), _LETTERS)


def _is_drawn(
    chosen: MapRoads, letters: Booleans, colors: int, is_plan: Callable[[], bool]
) -> bool:
    """Whether it is rather a drawing, or a plan with dimensions; `is_plan` takes longest."""
    if chosen.styled:
        return False
    is_named = cache(lambda: are_named(chosen.roads, letters))
    drawn = is_drawing(chosen.all_tones, chosen.roads, letters, colors, is_named)
    return drawn or (not is_named() and is_plan())


def _wide(tone: MapTone) -> float:
    """Width of the wide roads of a tone, pixels; what spreads most is parking lots as well."""
    return max(tone.width * max(1.0, tone.spread / MOST_SPREAD), tone.steady_wide)


def _differing(one: Image, other: Image) -> float:
    """Share of the pixels (h, w, 3) in which two pictures differ."""
    if one is other:
        return 0.0
    blue, green, red = cv2.split(cv2.absdiff(one, other))
    return float(np.count_nonzero(blue | green | red) / blue.size)


def _masks(
    seen: list[Booleans], chosen: MapRoads, letters: Booleans, thin: bool
) -> tuple[Booleans, list[Booleans]]:
    """Where (h, w) the roads are, and where each of the other colors is, as `seen` (h, w).

    Thin roads and what is beside them are also as they are without letters, but not on these.
    """
    mask, others = np.zeros(seen[0].shape, bool), []
    for one, plain in zip(seen, chosen.tones, strict=True):
        same = (road for road in chosen.roads if np.array_equal(road.color, plain.color))
        road = next(same, None)
        if road is None:
            others.append(one | (plain.mask & ~letters) if thin else one)
        elif not thin:
            streets = parts_touching(one, road.mask) if road.shared else one
            mask |= streets
            others.append(one & ~streets)
        else:
            mask |= parts_touching(one, road.mask) | (road.mask & ~letters)
    short = chosen.roads if thin else [road for road in chosen.roads if road.shared]
    if short:
        near = _grown(mask | letters if thin else letters, _NEAR)
        mask |= short_parts(chosen.tones, short, near) & ~letters
    return mask, others


def _uncovered(
    mask: Booleans,
    others: list[Booleans],
    letters: Booleans,
    widths: tuple[float, float, float],
) -> tuple[Booleans, Layer]:
    """The surface with what letters and casings cover, and how likely roads are hidden, 0..1."""
    width, typical, widest = widths
    area = np.zeros(mask.shape, bool)
    for other in others:
        if np.count_nonzero(other & letters) < _ON_LETTERS * np.count_nonzero(other):
            area |= opened_by_square(other, _EDGE)
    streets, named = streets_below_names(_without_thin(mask, width), letters, width)
    mask = streets | (mask & ~(named & ~opened_by_square(mask, max(1, int(_OUTLINE * width)))))
    mask = mask | (_closed(mask, _STROKE) & letters & ~area)
    surface = _without_areas(without_specks(_without_thin(mask, width), 0.5 * width**2), widest)
    near = _closed(surface, _GAP * width) | (_closed(surface, _LETTER_GAP * typical) & letters)
    surface = without_holes(surface | (near & ~area), _HOLE * width**2)
    surface = _without_islands(surface, _LONG * width)
    covered = _grown(surface, width) | opened_by_square(~surface & ~area, _EDGE) | letters
    hidden = np.where(surface, _ROAD, np.where(area | ~covered, _LAND, _UNKNOWN))
    return surface, hidden.astype(np.float32)


def _grown(mask: Booleans, radius: float) -> Booleans:
    """With what is within so many pixels of it."""
    return grown_by(mask, 2 * round(radius) + 1)


def _closed(mask: Booleans, radius: float) -> Booleans:
    return closed_by(mask, 2 * max(1, round(radius)) + 1)


def _without_areas(mask: Booleans, widest: float) -> Booleans:
    """Without what is far wider than roads are: squares and parking lots of the same color."""
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    core = inner > _WIDE / 2 * widest
    if not core.any():
        return mask
    return mask & ~grown_by(core, 2 * int(np.ceil(_WIDE / 2 * widest)) + 1)


def _without_thin(mask: Booleans, width: float) -> Booleans:
    """Without what is not nearly as wide as a road: railways of the same color."""
    size = max(1, int(_THIN * width))
    core = opened_by_square(mask, size).view(np.uint8)
    return np.asarray(mask & (cv2.dilate(core, np.ones((3, 3), np.uint8)) > 0))


def _without_islands(mask: Booleans, least: float) -> Booleans:
    """Without parts that are nowhere `least` pixels long, buildings of a road's color, and without
    rings of thin lines that nothing joins: outlines."""
    _, parts, stats = parts_and_boxes(mask)
    kept = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) >= least
    kept[0] = False
    kept &= ~_rings(mask, parts, len(stats))
    return where_parts(kept, parts)


def _rings(mask: Booleans, parts: NDArray[np.int32], count: int) -> Booleans:
    """Which of the connected parts (n,) of a mask (h, w) are thin lines around one hole, without
    ends; never the largest part."""
    line = skeleton(mask)
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    near = cv2.filter2D(line.astype(np.uint8), -1, np.ones((3, 3)), borderType=cv2.BORDER_CONSTANT)
    length = np.maximum(np.bincount(parts[line], minlength=count), 1)
    ends = np.bincount(parts[line & (near <= 2)], minlength=count)
    width = 2 * np.bincount(parts[line], weights=inner[line], minlength=count) / length - 1
    rings = (holes(mask, parts, count) == 1) & (ends == 0) & (width < THIN)
    rings[length.argmax()] = False
    return np.asarray(rings)
