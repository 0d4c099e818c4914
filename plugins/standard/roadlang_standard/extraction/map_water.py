"""Rivers and lakes that have the color of the roads, as on maps in black and white."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .map_tones import MapTone, is_gray, map_tone
from .skeleton import skeleton

_WIDE, _UNEVEN_WIDE, _BEYOND = 1.9, 1.4, 1.3
"""Water is so many times as wide as wide roads are; less will do where its width varies, and least
where it also goes on from other water, beyond a bridge."""
_WIDER = 1.15
"""Usual width of water over that of the roads, at least: a wide road may have narrow ones on it."""
_UNEVEN = 1.07
"""The width of the wide tenth of what is uneven, over its usual width."""
_BRIDGE = 0.8
"""Bridges are up to so many times as wide as wide roads."""
_SHORT = 12
"""Parts with center lines of fewer pixels are not looked at."""


@dataclass(frozen=True)
class _Width:
    """Of a connected part, pixels: its usual width, and that of its wide tenth."""

    usual: float
    wide: float

    @property
    def uneven(self) -> bool:
        return self.wide > _UNEVEN * self.usual

    def exceeds(self, road: _Width, times: float) -> bool:
        """Whether it is usually wider than a road, and its wide tenth so many times as wide."""
        return self.usual > _WIDER * road.usual and self.wide > times * road.wide


def without_water(tones: list[MapTone]) -> list[MapTone]:
    """The tones of a map, without water as in `masks_without_water`."""
    dry = masks_without_water([tone.color for tone in tones], [tone.mask for tone in tones])
    return [
        tone if mask is tone.mask else map_tone(tone.color, mask)
        for tone, mask in zip(tones, dry, strict=True)
    ]


def masks_without_water(colors: list[NDArray[np.float64]], masks: list[Booleans]) -> list[Booleans]:
    """Where (h, w) the colors of a map are, the grays darker than its land without what looks like
    water among roads.

    Water is nowhere lighter than the land. A colored tone is kept whole: without its wide part,
    the remnants of a park between streets would look like roads.
    """
    land = colors[int(np.argmax([np.count_nonzero(mask) for mask in masks]))]
    dry = []
    for color, mask in zip(colors, masks, strict=True):
        dark = is_gray(color) and color.mean() < land.mean()
        water = _water(mask) if dark else None
        dry.append(mask if water is None else np.asarray(mask & ~water))
    return dry


def _water(mask: Booleans) -> Booleans | None:
    """What of a tone (h, w) is wider than roads and apart from the longest network; None if
    nothing.

    Roads join. Where one crosses water of its own color, its casing parts both; a wide road that
    passes over others is apart as well, but even.
    """
    _, labels = cv2.connectedComponents(mask.astype(np.uint8), connectivity=4)
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    thin = skeleton(mask)
    lengths = np.bincount(labels[thin], minlength=2)
    widths: dict[int, _Width] = {}
    for part in np.flatnonzero(lengths >= _SHORT):
        across = 2 * inner[thin & (labels == part)] - 1
        widths[int(part)] = _Width(float(np.median(across)), float(np.quantile(across, 0.9)))
    road = widths.pop(int(np.argmax(lengths)), None)
    if road is None:
        return None
    found = {
        part
        for part, width in widths.items()
        if width.exceeds(road, _UNEVEN_WIDE if width.uneven else _WIDE)
    }
    also = {part for part, width in widths.items() if width.uneven and width.exceeds(road, _BEYOND)}
    reach = 2 * round(_BRIDGE * road.wide) + 1
    water = _joined(labels, found, also, reach) if found else found
    return np.isin(labels, list(water)) if water else None


def _joined(labels: np.ndarray, found: set[int], also: set[int], reach: int) -> set[int]:
    """The parts `found`, and those of `also` that are near them, one after the other."""
    water = set(found)
    kernel = np.ones((reach, reach), np.uint8)
    while found:
        near = cv2.dilate(np.isin(labels, list(found)).astype(np.uint8), kernel) > 0
        found = ({int(label) for label in np.unique(labels[near])} & also) - water
        water |= found
    return water
