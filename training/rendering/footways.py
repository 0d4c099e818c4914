"""Footways: pale strips beside the streets, behind a verge; they are no roads."""

from __future__ import annotations

import numpy as np

from training.rendering.frame import Layer, PlannedRoad, ribbon
from training.rendering.noise import blend
from training.rendering.pavement import offset
from training.rendering.setting import Setting


def lay_footways(
    rng: np.random.Generator, setting: Setting, image: Layer, plan: list[PlannedRoad]
) -> None:
    """Lay them along both sides of most streets, in place, before the streets are paved."""
    frame = setting.frame
    verge, width = rng.uniform(0, 3.0), rng.uniform(1.2, 2.2)
    tone = np.clip(rng.uniform(0.5, 0.85) * rng.normal(1, 0.02, 3), 0, 1)
    worn = rng.uniform(0.4, 1)
    for road in plan:
        if road.manner != "street" or rng.random() < 0.15:
            continue
        for side in (-1, 1):
            line = offset(road.points, side * (0.5 * road.width + verge + 0.5 * width))
            window, alpha = ribbon(frame.pixels(line), frame.length(width), frame.shape)
            blend(image[window], tuple(tone), alpha * worn)
