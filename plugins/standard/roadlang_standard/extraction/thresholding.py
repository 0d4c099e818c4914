"""The paper's chain for clean pictures: gray, blur, threshold, contours, spline."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from .drawing import between_lines, likeness
from .found_network import FoundNetwork
from .masks import roads_of_surface
from .tones import Image, Layer, away_from, tones


@dataclass(frozen=True)
class ContourSteps:
    """The steps. `threshold` is a gray in 0..1, None finds it (Otsu 1979).

    `road` says which side of the threshold is road: "dark", "light", or "auto".
    `between` reads two edge lines as the road between them where the picture has such lines.
    """

    blur: float = 0.0
    threshold: float | None = None
    road: str = "auto"
    between: bool = True
    spline: bool = True
    width: float | None = None
    min_length: float | None = None


def roads_by_contour(image: Image, chain: ContourSteps) -> FoundNetwork:
    """Roads (pixels) of a picture (h, w, 3) whose road differs from all else by its tone."""
    gray = _gray(image, chain)
    if chain.blur > 0:
        gray = cv2.GaussianBlur(gray, (0, 0), chain.blur)
    level = chain.threshold * 255 if chain.threshold is not None else _otsu(gray)
    light = _soft(gray, level)
    if light is None:
        empty = np.zeros(gray.shape, bool)
        return FoundNetwork(np.zeros((0, 2)), (), empty, "contour", ("the picture has one tone",))
    surface, settings = _surface(light, chain)
    found = roads_of_surface(surface, settings, chain.spline, chain.width, chain.min_length)
    return replace(found, scores={"threshold": round(level / 255, 4)})


def _gray(image: Image, chain: ContourSteps) -> Layer:
    """Gray; or, where no threshold is given and gray parts no tones, distance to the paper."""
    gray: Layer = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY).astype(np.float32)
    if chain.threshold is not None or chain.road != "auto":
        return gray
    plan = tones(image)
    if plan.covered < 0.9 or len(plan.colors) < 2:
        return gray
    weights = np.array([0.114, 0.587, 0.299])
    paper, other = (plan.colors[i] for i in (plan.paper, 1 if plan.paper == 0 else 0))
    if abs(float((paper - other) @ weights)) > 40:
        return gray
    return away_from(image, paper).astype(np.float32)


def _otsu(gray: Layer) -> float:
    plain = np.clip(gray, 0, 255).astype(np.uint8)
    level, _ = cv2.threshold(plain, 0, 255, cv2.THRESH_BINARY | cv2.THRESH_OTSU)
    return float(level) + 0.5


def _soft(gray: Layer, level: float) -> Layer | None:
    """Lightness in 0..1, the level at one half, linear between the usual tones of both sides."""
    step = max(1, int(np.sqrt(gray.size / 400_000)))
    sample = gray[::step, ::step]
    low, high = sample[sample < level], sample[sample >= level]
    if not len(low) or not len(high):
        return None
    dark, bright = float(np.median(low)), float(np.median(high))
    below = (gray - level) / max(level - dark, 0.5)
    above = (gray - level) / max(bright - level, 0.5)
    return np.clip(0.5 + 0.5 * np.where(gray < level, below, above), 0, 1).astype(np.float32)


def _surface(light: Layer, chain: ContourSteps) -> tuple[Layer, str]:
    sides = {"light": light, "dark": 1 - light}
    if chain.road != "auto":
        return sides[chain.road], "contour"
    rim = np.concatenate([light[0], light[-1], light[:, 0], light[:, -1]])
    if chain.between:
        ink = 1 - light if rim.mean() > 0.5 else light
        between = between_lines(ink >= 0.5)
        if between is not None:
            return between, "edge lines"
    return max(sides.values(), key=likeness), "contour"
