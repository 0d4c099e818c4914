"""The sizes at which a photo is processed: from its ground resolution, else from its sharpness."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.tones import Image

_GROUND = 0.9
"""Meters per pixel at which the net works best."""
_NO_DETAIL = 0.002
"""Photos that are blurred, or enlarged three times, have less fine detail than this."""
_FINEST = 3.0
"""Size of the largest view of a photo of known resolution, relative to the optimal view."""


def view_scales(image: Image, meters_per_pixel: float | None = None) -> tuple[float, ...]:
    """The factors by which to resize a photo before processing, the largest first; 1 or less.

    A known resolution determines the optimal size. Without one, only a photo without fine detail
    is also processed at half size, because it may have been enlarged.
    """
    smallest = min(1.0, 64 / min(image.shape[:2]))
    if meters_per_pixel is not None:
        wanted = meters_per_pixel / _GROUND
        if wanted >= 0.72:
            return (1.0,)
        best = float(np.clip(wanted, max(0.1, smallest), 1.0))
        return tuple(sorted({min(1.0, _FINEST * best), best}, reverse=True))
    return (1.0,) if has_detail(image) else tuple(sorted({1.0, max(0.5, smallest)}, reverse=True))


def has_detail(image: Image) -> bool:
    """Whether a photo has fine detail: one that was enlarged or is blurred has none."""
    return fine_share(image) >= _NO_DETAIL


def fine_share(image: Image) -> float:
    """Share of spectral energy above a quarter of the sampling rate: tiny in enlarged photos."""
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    height, width = (min(1024, side) for side in gray.shape)
    top, left = (gray.shape[0] - height) // 2, (gray.shape[1] - width) // 2
    part = gray[top : top + height, left : left + width].astype(np.float32)
    part -= part.mean()
    part *= np.outer(np.hanning(height), np.hanning(width)).astype(np.float32)
    energy = np.abs(np.fft.rfft2(part)) ** 2
    rate = np.hypot(np.fft.fftfreq(height)[:, None], np.fft.rfftfreq(width)[None])
    total = float(energy[rate > 0.005].sum())
    return float(energy[rate > 0.25].sum()) / total if total > 0 else 1.0


def resized(image: Image, scale: float) -> Image:
    """The picture `scale` times as large, without aliasing."""
    if scale == 1:
        return image
    size = (max(1, round(image.shape[1] * scale)), max(1, round(image.shape[0] * scale)))
    interpolation = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
    return np.asarray(cv2.resize(image, size, interpolation=interpolation))
