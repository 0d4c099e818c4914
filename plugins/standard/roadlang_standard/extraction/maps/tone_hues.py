"""Hues of a map: those of main roads, of water and of plants."""

from __future__ import annotations

import colorsys

import numpy as np

from .map_tones import MapTone

ALL_RIBBONS = 0.95
"""A tone with at least this share of its surface in ribbons is nearly all ribbons."""
_WATER_HUES, _BLUISH = (165 / 360, 209 / 360), 230 / 360
"""Wide water has a hue between `_WATER_HUES`. Up to the hue `_BLUISH`, a tone is water if it is
darker than the land where roads are lighter, or lighter where they are darker."""
_RIVER_STEADY = 0.75
"""A wide bluish tone is also water if it keeps its width on less than this share of its surface:
motorways keep it on more."""
_TINTED = 250 / 360
"""Where streets are gray, a wide and nearly gray tone up to this hue is water: main roads have
clear colors."""
_GREEN_HUES = 75 / 360, 160 / 360
"""Hues of parks, woods and meadows."""
_WIDE = 1.5
"""Water is more than this many times as wide as the main roads."""
_SATURATED, _WARM, _WARM_STEADY = 0.22, (70 / 360, 320 / 360), 0.08
"""A tone with at least the saturation `_SATURATED`, and a hue outside the range `_WARM`, is often
that of main roads: it needs to keep its width on only `_WARM_STEADY` of its surface."""


def is_warm(tone: MapTone) -> bool:
    """Whether a tone has a clear red, orange or yellow, which land does not have, and is nearly all
    ribbons. Such tones are main roads, even if their width varies because carriageways and ramps
    split and merge."""
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
