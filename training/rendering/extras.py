"""What makes a scene harder to read: thickets, railways, clearings, wrack lines; all optional."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from training.rendering.frame import Layer
from training.rendering.noise import blend, smooth
from training.rendering.railways import lay_railway
from training.rendering.setting import Setting


@dataclass(frozen=True, slots=True)
class Extras:
    """How much of each; drawn apart from the scene, so that a scene without them stays the same."""

    seed: int
    thicket: float
    """Share of the ground under small crowns and bushes, about 0..0.8."""
    over_roads: float
    """The same share on the roads."""
    grain: float
    """Deviation of the fine texture of the ground."""
    tracks: int
    """Of the railway; none without one."""
    clearing: bool
    """A straight strip without trees, as under a power line."""
    built_up: float | None
    """Gray of the ground of a town without lawns; others have them."""
    wrack: bool
    """Lines along the water: wrack, dunes, edges of tidal flats."""


def extras_of(rng: np.random.Generator) -> Extras:
    """As photographs have them: crowns over roads in 40 % of the scenes, railways in 25 %."""
    overgrown = rng.random() < 0.4
    railway = rng.random() < 0.25
    return Extras(
        seed=int(rng.integers(2**31)),
        thicket=float(rng.uniform(0.05, 0.75)) if rng.random() < 0.7 else 0.0,
        over_roads=float(rng.uniform(0.05, 0.45)) if overgrown else 0.02,
        grain=float(rng.uniform(0.02, 0.16)),
        tracks=int(rng.choice([1, 2, 3, 6, 10], p=[0.4, 0.35, 0.1, 0.1, 0.05])) if railway else 0,
        clearing=bool(rng.random() < 0.15),
        built_up=float(rng.uniform(0.2, 0.6)) if rng.random() < 0.2 else None,
        wrack=bool(rng.random() < 0.5),
    )


def lay_extras(setting: Setting, extras: Extras, image: Layer, water: Layer) -> None:
    """Paint what lies on the bare ground, in place."""
    rng = np.random.default_rng([extras.seed, 0])
    if extras.wrack and (water > 0.5).any() and not (water > 0.5).all():
        _wrack(rng, setting, image, water)
    if extras.tracks:
        lay_railway(rng, setting, image, extras.tracks)


def _wrack(rng: np.random.Generator, setting: Setting, image: Layer, water: Layer) -> None:
    """Sand along the water with lines of wrack, dunes and paths in it, at even distances."""
    dry = (water < 0.5).astype(np.uint8)
    away = cv2.distanceTransform(dry, cv2.DIST_L2, 5) * setting.frame.meters_per_pixel
    away = away * (1 + 0.12 * smooth(rng, setting.frame, rng.uniform(20, 80)))
    width = rng.uniform(8, 70)
    sand = np.clip(np.array(setting.palette["soil"]) * rng.uniform(1.0, 1.6), 0, 1)
    beach = np.clip((width - away) / rng.uniform(1, 8) + 0.5, 0, 1) * dry
    blend(image, tuple(sand), (beach * rng.uniform(0.5, 1)).astype(np.float32))
    for _ in range(int(rng.integers(1, 5))):
        at, half = rng.uniform(1, width), rng.uniform(0.4, 4)
        line = np.clip((half - np.abs(away - at)) / rng.uniform(0.5, 2) + 0.5, 0, 1) * dry
        broken = np.clip(1 + 0.8 * smooth(rng, setting.frame, 40), 0, 1)
        tone = np.clip(sand * rng.uniform(0.35, 1.25), 0, 1)
        blend(image, tuple(tone), (line * broken * rng.uniform(0.3, 1)).astype(np.float32))
