"""Evidence of roads in a photo: at full and half size, and of wide roads by a second net."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from ..colors.tones import Image, Layer
from ..masks.mask_parts import without_specks
from .exposure import even_view
from .road_net import Net, evidence
from .scale import resized

_COARSE = 0.35
"""Share of the half-size view in the evidence."""
_NARROW, _WIDE = 10.0, 14.0
"""Typical widths of roads, in pixels, up to which the second net has no share and from which on it
has all of `_SHARE`: it sees wide streets better, and photos at 1 m/px worse."""
_SHARE = 0.4
"""Of the second net in the mean log odds, by half of 51 photos."""
_SUREST = 1e-4
"""Probabilities nearer to 0 or 1 than this count as this near."""


@dataclass(frozen=True)
class Seen:
    """Road surface (h, w), 0..1: as seen at full size, and blended with the view at half size."""

    surface: Layer
    blend: Layer


def look(image: Image, net: Net) -> Seen:
    """Evidence at the picture's size, and its blend with that of a half-size view.

    The second net looks only if the first one sees wide roads, at full size: what looks wide in the
    half-size view alone is often none.
    """
    views = [image] if min(image.shape[:2]) < 96 else [image, resized(image, 0.5)]
    evened = [even_view(view) for view in views]
    surfaces = [evidence(view, net.predict) for view in evened]
    share = share_of_second(typical_width(surfaces[0]))
    if net.second is not None and share > 0:
        others = [evidence(view, net.second, mirrored=False) for view in evened]
        surfaces = [_mean_of_odds(*both, share) for both in zip(surfaces, others, strict=True)]
    fine = surfaces[0]
    if len(surfaces) == 1:
        return Seen(fine, fine)
    coarse = cv2.resize(surfaces[1], image.shape[1::-1])
    return Seen(fine, cv2.addWeighted(fine, 1 - _COARSE, coarse, _COARSE, 0))


def share_of_second(width: float) -> float:
    """Of the second net, where roads are typically so many pixels wide."""
    return _SHARE * float(np.clip((width - _NARROW) / (_WIDE - _NARROW), 0, 1))


def typical_width(surface: Layer) -> float:
    """Usual width of what is surely road, in pixels."""
    mask = without_specks(surface > 0.8, 40)
    inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
    ridge = inner[(inner >= cv2.dilate(inner, np.ones((3, 3), np.uint8))) & mask]
    ridge = np.minimum(ridge, max(mask.shape))  # infinite where all is road
    return float(2 * np.median(ridge) - 1) if len(ridge) else 0.0


def _mean_of_odds(first: Layer, second: Layer, share: float) -> Layer:
    """Probabilities whose log odds are the weighted means; `share` is that of the second."""
    odds = (1 - share) * _log_odds(first) + share * _log_odds(second)
    return np.asarray(1 / (1 + np.exp(-odds)), np.float32)


def _log_odds(share: Layer) -> Layer:
    clear = np.clip(share, _SUREST, 1 - _SUREST)
    return np.asarray(np.log(clear / (1 - clear)), np.float32)
