"""Tell what sort of picture it is: a photo, a mask, a filled drawing, a drawing of edge lines."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .drawing import between_lines
from .tones import Image, flatness, tones

PHOTO, MASK, FILLED, EDGES, MAP = (
    "photo",
    "mask",
    "filled drawing",
    "edge-line drawing",
    "colour map",
)


@dataclass(frozen=True)
class PictureKind:
    """What a picture is, and how that was seen."""

    name: str
    flat: float
    """Share of pixels without any texture."""

    @property
    def drawn(self) -> bool:
        """Whether it is anything but a photo."""
        return self.name != PHOTO


def picture_kind(image: Image) -> PictureKind:
    """Photos have texture nearly everywhere, drawings nearly nowhere."""
    flat = flatness(image)
    plan = tones(image, most=12)
    few = float(np.sort(plan.shares)[::-1][:6].sum())
    if flat < 0.55 or few < 0.85:
        return PictureKind(PHOTO, flat)
    paper = plan.colours[plan.paper]
    marked = np.abs(image.astype(np.int16) - paper.astype(np.int16)).max(axis=2) > 100
    if not marked.any():
        marked = np.abs(image.astype(np.int16) - paper.astype(np.int16)).max(axis=2) > 30
    if between_lines(marked) is not None:
        return PictureKind(EDGES, flat)
    black_and_white = all(min(c.max(), 255 - c.min()) < 40 for c in plan.colours[:2])
    if black_and_white and len(plan.colours) <= 2 and paper.mean() < 40:
        return PictureKind(MASK, flat)
    return PictureKind(MAP if len(plan.colours) > 3 else FILLED, flat)
