"""The paper's chain for clean pictures: gray, blur, threshold, contours, spline."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image, Layer, away_from, tones
from ..networks.found_network import EDGE_LINES, FoundNetwork
from .dashed_roads import with_dashes_joined
from .drawing import between_lines, most_like_roads
from .pale_roads import pale_surfaces
from .road_markings import with_markings_filled
from .surface_roads import roads_of_surface
from .title_bars import without_title_bars

_DOUBTFUL = 0.5
"""Roads less sure may be names: then roads are sought in the ground between these."""


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
        layer: Layer = cv2.GaussianBlur(gray.astype(np.float32), (0, 0), chain.blur)
        level = _level(np.clip(layer, 0, 255).astype(np.uint8), chain)
        light = _soft(layer, level)
    else:
        level = _level(gray, chain)
        light = _soft_by_levels(gray, level)
    if light is None:
        empty = np.zeros(gray.shape, bool)
        return FoundNetwork(np.zeros((0, 2)), (), empty, "contour", ("the picture has one tone",))
    surface, settings = _surface(light, chain, image)
    fixed = (chain.spline, chain.width, chain.min_length)
    found = roads_of_surface(surface, settings, *fixed)
    if found.confidence < _DOUBTFUL and chain.threshold is None and chain.road == "auto":
        pale = pale_surfaces(gray, level)
        if pale is not None:
            other = roads_of_surface(with_markings_filled(_road(pale), image), "contour", *fixed)
            found = max((found, other), key=lambda network: network.confidence)
    return replace(found, scores={"threshold": round(level / 255, 4)})


def _gray(image: Image, chain: ContourSteps) -> Image:
    """Gray; or, where no threshold is given and gray parts no tones, distance to the paper."""
    gray: Image = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    if chain.threshold is not None or chain.road != "auto":
        return gray
    plan = tones(image)
    if plan.covered < 0.9 or len(plan.colors) < 2:
        return gray
    weights = np.array([0.114, 0.587, 0.299])
    paper, other = (plan.colors[i] for i in (plan.paper, 1 if plan.paper == 0 else 0))
    if abs(float((paper - other) @ weights)) > 40:
        return gray
    return away_from(image, paper)


def _level(gray: Image, chain: ContourSteps) -> float:
    """The gray, 0..255, that parts road from ground."""
    if chain.threshold is not None:
        return chain.threshold * 255
    level, _ = cv2.threshold(gray, 0, 255, cv2.THRESH_BINARY | cv2.THRESH_OTSU)
    return float(level) + 0.5


def _soft_by_levels(gray: Image, level: float) -> Layer | None:
    """As `_soft`, worked out once for each of 256 levels of gray (h, w)."""
    sample = np.ascontiguousarray(_sampled(gray))
    counts = cv2.calcHist([sample], [0], None, [256], [0, 256]).ravel().astype(np.int64)
    levels = np.arange(256, dtype=np.float32)
    is_low = levels < level
    if not counts[is_low].any() or not counts[~is_low].any():
        return None
    usual = [_median(levels[side], counts[side]) for side in (is_low, ~is_low)]
    return np.asarray(cv2.LUT(gray, _lightness(levels, level, *usual)))


def _median(levels: Layer, counts: NDArray[np.int64]) -> float:
    """Of levels (n,) in ascending order, each of which is there so many times (n,)."""
    total = int(counts.sum())
    middle = [(total - 1) // 2, total // 2]
    return float(levels[np.searchsorted(np.cumsum(counts), middle, side="right")].mean())


def _soft(gray: Layer, level: float) -> Layer | None:
    """Lightness (h, w) in 0..1, the level at one half, linear between the usual tones of both
    sides; None if one has none."""
    sample = _sampled(gray)
    low, high = sample[sample < level], sample[sample >= level]
    if not len(low) or not len(high):
        return None
    return _lightness(gray, level, float(np.median(low)), float(np.median(high)))


def _sampled(gray: NDArray[Any]) -> NDArray[Any]:
    step = max(1, int(np.sqrt(gray.size / 400_000)))
    return gray[::step, ::step]


def _lightness(gray: Layer, level: float, dark: float, bright: float) -> Layer:
    below = (gray - level) / max(level - dark, 0.5)
    above = (gray - level) / max(bright - level, 0.5)
    return np.clip(0.5 + 0.5 * np.where(gray < level, below, above), 0, 1).astype(np.float32)


def _surface(light: Layer, chain: ContourSteps, image: Image) -> tuple[Layer, str]:
    if chain.road != "auto":
        return (light if chain.road == "light" else 1 - light), "contour"
    if chain.between:
        between = between_lines(_ink(light))
        if between is not None:
            return between, EDGE_LINES
    road = with_markings_filled(_road((light, 1 - light)), image)
    return with_dashes_joined(road), "contour"


def _ink(light: Layer) -> Booleans:
    """What is darker (h, w) than the level where most of the rim is light, else what is lighter."""
    rim = np.concatenate([light[0], light[-1], light[:, 0], light[:, -1]])
    return np.asarray(light <= 0.5 if rim.mean() > 0.5 else light >= 0.5)


def _road(surfaces: tuple[Layer, ...]) -> Layer:
    return most_like_roads([without_title_bars(surface) for surface in surfaces])
