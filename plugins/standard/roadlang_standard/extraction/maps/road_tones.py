"""Which colors of a rendered map are roads: even ribbons that join one another, and no water."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..masks.mask_parts import parts_touching, without_specks
from .map_tones import EXACT, MapTone, map_tone
from .tone_hues import (
    ALL_RIBBONS,
    has_water_hue,
    is_bluish,
    is_green,
    is_tinted_blue,
    is_warm,
    is_water,
)
from .tone_shape import SPECK, THINNEST

_STEADY, _SURE, _ALSO_STEADY = 0.35, 0.45, 0.25
"""Least share of its surface that keeps its width, of the tone with most road; what makes any tone
a road's; and what does together with the next ones."""
_RAGGED_EVEN, _RAGGED_SPREAD, _RAGGED_RIBBONS = 0.65, 1.5, 0.95
"""Least even width of roads whose edges JPEG frayed, most spread, and least share in ribbons."""
_RIBBONS, MOST_SPREAD, _WIDEST = 0.7, 2.1, 0.12
"""Least share of a tone's surface in ribbons; most that wide parts exceed the usual width; and most
width, as a share of the shorter side."""
_VERY_STEADY, _FEW_RIBBONS = 0.9, 0.6
"""Least share in ribbons of what keeps its width so well: JPEG breaks thin streets to pieces."""
_PLAIN_SPREAD = 2.6
"""Most spread of black, gray and white: wide and narrow roads have it where a map has one color for
all."""
_ALSO_EVEN = 0.4
"""Least share of even width of further roads: names hide more of roads that are few."""
_LEAST = 0.5
"""Least length of roads, as a share of the picture's shorter side."""
_AREA = 4.3
_AREAS = 0.25
"""A tone wider than a road by the given factor on more than this share of its surface is an
area."""
_CASING, _BESIDE = 3.0, 0.5
"""Casings are at most `_CASING` pixels wide, and more than `_BESIDE` of them is beside a wider
road, ..."""
_THICKEST, _HALF, _LINED = 5.0, 0.6, 0.6
"""or they are at most `_THICKEST` pixels and `_HALF` of the road wide, and line more than `_LINED`
of its edge: at high resolution, outlines of houses have this color too."""
_MANY = 0.3
"""Thin lines are streets if their length is at least this share of that of the main roads; railways
are shorter."""
_HAIR = 1.2
"""Lines of at most this width, in pixels, are outlines of houses and roads."""
_TOUCHING, _CUT = 0.4, 0.15
"""Least share of a tone that lies in parts which touch other roads; of wide and even ones, which
names cut."""
_ALONE_STEADY, _ALONE_EVEN, _ALONE_WIDE = 0.6, 0.75, 0.5
"""Least share of its surface and of its length that keeps its width, and least width as a share of
that of the main roads, of what is a road wherever it is, ..."""
_FEW = 3
"""if the picture has more colors than this: otherwise they are drawn roads and lettering."""
_BESIDE_REST = 0.5
"""What is left of a color where most of that is water or land is no road, if another color is even
over at least this share of its length."""
_EDGE, _EDGES = 4, 0.4
"""Tones touch across edge lines of up to `_EDGE` pixels, or `_EDGES` of a road's width."""


def road_tones(tones: list[MapTone], side: int) -> list[MapTone]:
    """Those of the tones that are roads, the one with most road first; `side` in pixels."""
    land = max(tones, key=lambda tone: np.count_nonzero(tone.mask))
    ribbons = [
        tone
        for tone in tones
        if tone is not land and tone.width <= _WIDEST * side and _is_steady(tone)
    ]
    several = len(tones) > _FEW
    ribbons = [tone for tone in ribbons if not _is_casing(tone, ribbons, land, several)]
    sure = [tone for tone in ribbons if tone.steady >= _STEADY]
    # Hair lines are even, such as tracks in a yard: streets are longer in all where they are wider.
    # If most of their color is land, they are its edges.
    longest = max((tone.steady_length for tone in sure if tone.width > _HAIR), default=0.0)
    sure = [
        tone
        for tone in sure
        if tone.width > _HAIR or (tone.steady_length > longest and not tone.rest)
    ]
    sure = [tone for tone in sure if tone.steady_length >= _LEAST * side]
    if not sure:
        return []
    # Squares: what is far less even than any roads may still be long in all. Strips of plants are
    # as even as roads, but few maps have green roads, and these have nothing else.
    main = max([tone for tone in sure if not is_green(tone)] or sure, key=_evenness)
    whole = [tone for tone in sure if not tone.rest and not is_green(tone)]
    most = max(whole, key=_evenness, default=main)
    # Strips of land are even as well, but few beside the roads that these maps have.
    if main.rest and _evenness(most) >= _BESIDE_REST * _evenness(main):
        main = most
    others = [
        tone
        for tone in ribbons
        if tone is not main
        and (main.rest or not tone.rest)
        and tone.width > _HAIR
        and (tone.width > THINNEST or tone.steady_length >= _MANY * main.steady_length)
        and not _is_area(tone, _AREA * max(main.width, tone.width))
        and not is_water(tone, main, land)
    ]
    taken = _joined(main, others, [one for one in others if several and _is_road_alone(one, main)])
    # A river between a few streets may be longer and more even than they are.
    if has_water_hue(main) and sum(tone.steady_length for tone in taken) >= _LEAST * side:
        return taken
    return [main, *taken]


def _evenness(tone: MapTone) -> float:
    """How long a tone keeps its width, in pixels, of which uneven parts count little."""
    return tone.steady_length * (tone.steady * tone.even) ** 2


def _is_steady(tone: MapTone) -> bool:
    """Whether a tone keeps its width along enough of it to be a road's."""
    if tone.ribbons < (_RIBBONS if tone.steady < _VERY_STEADY else _FEW_RIBBONS):
        return False
    if (
        not is_green(tone)
        and tone.even >= _RAGGED_EVEN
        and tone.spread <= _RAGGED_SPREAD
        and tone.ribbons >= _RAGGED_RIBBONS
    ):
        return True
    return (
        tone.steady >= _SURE
        or (
            tone.steady >= _ALSO_STEADY
            and tone.even >= _ALSO_EVEN
            and tone.spread <= (_PLAIN_SPREAD if _is_plain(tone) else MOST_SPREAD)
        )
        or is_warm(tone)
    )


def _is_casing(tone: MapTone, ribbons: list[MapTone], land: MapTone, several: bool) -> bool:
    """Whether a tone is thin lines along the edges of wider roads: streets meet them at ends."""
    return any(
        _lies_along(tone, other, several)
        or (
            _lines(tone, other)
            and not _is_between(tone, other, land)
            and not _is_between(other, tone, land)
        )
        for other in ribbons
        if other.width > tone.width + 1 and other.mean_width > tone.mean_width
    )


def _lies_along(tone: MapTone, other: MapTone, several: bool) -> bool:
    if tone.width > _CASING:
        return False
    beside = _grown(other.mask, _EDGE)
    if beside[tone.mask].mean() <= _BESIDE or not several:
        return bool(beside[tone.mask].mean() > _BESIDE)
    # Main roads may be outlined in the color of the streets.
    rest = map_tone(tone.color, tone.mask & ~beside)
    return rest.ribbons * rest.length < _MANY * other.steady_length


def _lines(tone: MapTone, other: MapTone) -> bool:
    if tone.width > min(_THICKEST, _HALF * other.width):
        return False
    if other.steady_length < _MANY * tone.steady_length:
        return False
    edge = _grown(other.mask, 1) & ~other.mask
    return bool(_grown(without_specks(tone.mask, SPECK), 2)[edge].mean() > _LINED)


def _is_between(tone: MapTone, other: MapTone, land: MapTone) -> bool:
    """Whether a tone is a mixture of another one and the land, as a road's smoothed edge is."""
    axis = land.color - other.color
    share = float(np.clip((tone.color - other.color) @ axis / max(float(axis @ axis), 1.0), 0, 1))
    return bool(np.abs(tone.color - other.color - share * axis).max() <= EXACT.near)


def _grown(mask: Booleans, reach: int) -> Booleans:
    """A mask (h, w) with the pixels within so many columns and rows of it."""
    kernel = np.ones((2 * reach + 1, 2 * reach + 1), np.uint8)
    return np.asarray(cv2.dilate(mask.astype(np.uint8), kernel) > 0)


def _is_plain(tone: MapTone) -> bool:
    """Whether a tone is black, gray or white, and nearly all ribbons."""
    return tone.is_gray and tone.ribbons >= ALL_RIBBONS


def _is_area(tone: MapTone, width: float) -> bool:
    """Whether much of a tone is wider than so many pixels."""
    if tone.widest < width:
        return False
    inner = cv2.distanceTransform(tone.mask.astype(np.uint8), cv2.DIST_L2, 5)
    wide = cv2.distanceTransform((inner < width / 2).astype(np.uint8), cv2.DIST_L2, 5) < width / 2
    return bool(wide[tone.mask].mean() > _AREAS)


def _joined(main: MapTone, others: list[MapTone], apart: list[MapTone]) -> list[MapTone]:
    """Roads `apart`, and those of the others that touch roads already taken: one after another."""
    others = [tone for tone in others if all(tone is not one for one in apart)]
    taken: list[MapTone] = [*apart]
    size = 2 * max(_EDGE, round(_EDGES * main.width)) + 1
    kernel = np.ones((size, size), np.uint8)
    roads = np.logical_or.reduce([main.mask, *(tone.mask for tone in apart)])
    reach = cv2.dilate(roads.astype(np.uint8), kernel) > 0
    left = sorted(others, key=lambda tone: -tone.length)
    found = True
    while found:
        found = False
        for tone in [*left]:
            # Casings of a street's color touch all roads, and outlines of houses touch none.
            rest = tone.mask & ~reach if tone.width <= _CASING else tone.mask
            near = cv2.dilate(reach.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
            touching = parts_touching(rest, near)
            least = _CUT if _is_main(tone, main) else _TOUCHING
            if np.count_nonzero(touching) >= least * np.count_nonzero(rest):
                found, left = True, [one for one in left if one is not tone]
                whole = rest is tone.mask
                mask = tone.mask if whole else touching | (tone.mask & reach)
                taken.append(replace(tone, mask=mask))
                reach |= cv2.dilate(mask.astype(np.uint8), kernel) > 0
    return taken


def _is_road_alone(tone: MapTone, main: MapTone) -> bool:
    """Whether a tone is so even, wide and long that it needs to touch no other road: two classes of
    roads may meet beyond the picture's edge."""
    return (
        tone.steady >= _ALONE_STEADY
        and tone.even >= _ALONE_EVEN
        and tone.ribbons >= ALL_RIBBONS
        and tone.width > _CASING
        and tone.width >= _ALONE_WIDE * main.width
        and tone.steady_length >= _LEAST * min(tone.mask.shape)
        and not is_green(tone)
        and not (is_bluish(tone) or is_tinted_blue(tone))
    )


def _is_main(tone: MapTone, main: MapTone) -> bool:
    """Whether a tone is as even as roads alone are, and no narrower than `main`."""
    return tone.steady >= _SURE and tone.width >= main.width and not is_green(tone)
