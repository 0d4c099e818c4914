"""Hues of a map: those of main roads, of water and of plants."""

from __future__ import annotations

import colorsys

import numpy as np

from .map_tones import MapTone

ALL_RIBBONS = 0.95
"""Least share of its surface in ribbons of what is nearly all ribbons."""
_WATER_HUES, _BLUISH = (165 / 360, 209 / 360), 230 / 360
"""Water is of these hues where it is also wide, or bluish up to the other one where it differs from
the land in the other direction than roads do, darker or lighter."""
_RIVER_STEADY = 0.75
"""Or it is bluish and wide, and keeps its width on less of its surface than motorways."""
_TINTED = 250 / 360
"""Where streets are gray, water of up to this hue may be nearly gray, as main roads are not."""
_GREEN_HUES = 75 / 360, 160 / 360
"""Of parks, woods and meadows."""
_WIDE = 1.5
"""Least width of water over that of the main roads."""
_SATURATED, _WARM, _WARM_STEADY = 0.22, (70 / 360, 320 / 360), 0.08
"""Main roads often have at least this saturation and a hue outside this range; such tones may keep
their width along less of their surface."""


def is_warm(tone: MapTone) -> bool:
    """Whether a tone is red, orange or yellow as no land is, and nearly all ribbons: main roads,
    whose carriageways and ramps part and meet, so that their width varies."""
    blue, green, red = tone.color / 255
    hue, saturation, _ = colorsys.rgb_to_hsv(red, green, blue)
    return (
        saturation >= _SATURATED
        and not _WARM[0] < hue < _WARM[1]
        and tone.ribbons >= ALL_RIBBONS
        and tone.steady >= _WARM_STEADY
    )


def is_water(tone: MapTone, main: MapTone, land: MapTone) -> bool:
    """Whether a ribbon is a river rather than a road of another class than `main`."""
    if tone.is_gray:
        return False
    wide = tone.width > _WIDE * main.width
    if wide and (has_water_hue(tone) or (main.is_gray and is_tinted_blue(tone))):
        return True
    if wide and is_bluish(tone) and tone.steady < _RIVER_STEADY:
        return True
    directions = [float(np.sign(one.color.mean() - land.color.mean())) for one in (tone, main)]
    return is_bluish(tone) and directions[0] != directions[1]


def is_bluish(tone: MapTone) -> bool:
    """Whether a tone has a hue of water, or one that is nearer to violet."""
    return not tone.is_gray and _WATER_HUES[0] <= _hue(tone) <= _BLUISH


def has_water_hue(tone: MapTone) -> bool:
    """Whether a tone has a hue that water mostly has."""
    return not tone.is_gray and _WATER_HUES[0] <= _hue(tone) <= _WATER_HUES[1]


def is_tinted_blue(tone: MapTone) -> bool:
    """Whether a tone is nearly gray, but blue rather than that."""
    blue, green, red = tone.color / 255
    hue, saturation, _ = colorsys.rgb_to_hsv(red, green, blue)
    return _WATER_HUES[0] <= hue <= _TINTED and saturation < _SATURATED


def is_green(tone: MapTone) -> bool:
    """Whether a tone has a hue of plants."""
    return not tone.is_gray and _GREEN_HUES[0] <= _hue(tone) <= _GREEN_HUES[1]


def _hue(tone: MapTone) -> float:
    """Hue of a tone, 0..1."""
    blue, green, red = tone.color / 255
    return colorsys.rgb_to_hsv(red, green, blue)[0]
