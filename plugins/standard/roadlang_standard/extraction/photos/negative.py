"""The negative of a photo: where roads are dark on light ground, nets see them better in it."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.nodata import nodata
from ..colors.tones import Image, thinned

_LIGHT = -0.5
"""Ground is light if the grays have a smaller skewness: most of the picture is then lighter than
its mean. That of snow in renderings is below -0.5, that of 58 photos without snow above -0.33."""
_COLORED, _SHARE = 8, 0.01
"""A picture has colors if the channels of more than this share of it differ by more gray levels."""
_SAMPLE = 100_000


def exposures(image: Image) -> tuple[Image, ...]:
    """The photo (h, w, 3) and, if it shows light ground or has no colors, its gray negative.

    The nets learn from summer photos in color, whose roads are mostly lighter than the ground. In
    snow and in gray pictures of infrared light they may be the darkest of all.
    """
    if not (_has_light_ground(image) or _is_gray(image)):
        return (image,)
    gray = cv2.bitwise_not(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY))
    return image, np.asarray(cv2.merge([gray] * 3))


def _has_light_ground(image: Image) -> bool:
    sample = np.ascontiguousarray(thinned(image, _SAMPLE))
    gray = cv2.cvtColor(sample, cv2.COLOR_BGR2GRAY).astype(np.float64)
    margins = nodata(sample)
    seen = gray.ravel() if margins is None else gray[~margins]
    if not seen.size or seen.std() == 0:
        return False
    return bool((((seen - seen.mean()) / seen.std()) ** 3).mean() < _LIGHT)


def _is_gray(image: Image) -> bool:
    sample = thinned(image, _SAMPLE)
    differ = sample.max(axis=2) - sample.min(axis=2)
    return bool((differ > _COLORED).mean() <= _SHARE)
