"""Trees seen from above, many at once, in their own frame: pixels, center at (0, 0)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from . import palette
from .markup import element, number, numbers_text

if TYPE_CHECKING:
    from roadlang.geometry import Floats

_LAYERS = tuple(zip(reversed(palette.LEAVES), (1.0, 0.7, 0.38), (9, 7, 5), strict=True))
"""Color, share of the radius and number of lobes, from below."""
_LEAST_LOBED = 6.0
"""Pixels"""


def crowns(sizes: Sequence[float], variants: Sequence[int]) -> list[str]:
    """Crowns of scalloped layers, turned by their variant so that no two look the same; of small
    trees, whose lobes nobody can see, two discs."""
    fine = [index for index, size in enumerate(sizes) if size >= _LEAST_LOBED]
    found = dict(
        zip(fine, _lobed([sizes[i] for i in fine], [variants[i] for i in fine]), strict=True)
    )
    return [found.get(index) or _discs(size) for index, size in enumerate(sizes)]


@lru_cache(maxsize=256)
def _discs(size: float) -> str:
    outer, _, inner = (
        element("circle", r=share * size / 2.0, fill=color, **_outline(layer))
        for layer, (color, share, _) in enumerate(_LAYERS)
    )
    return outer + inner


def _outline(layer: int) -> dict[str, object]:
    return {"stroke": palette.TRUNK, "stroke_width": 0.6} if layer == 0 else {}


def _lobed(sizes: Sequence[float], variants: Sequence[int]) -> list[str]:
    import numpy as np

    radii, turns = np.array(sizes) / 2.0, 2.4 * np.array(variants)
    layers = []
    for layer, (color, share, lobes) in enumerate(_LAYERS):
        angles = turns + 2.1 * layer
        depths = 0.12 * radii * layer
        centers = depths[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
        around = element("path", d="@", fill=color, **_outline(layer)).split("@")
        lines = _scalloped(centers, 0.86 * share * radii, lobes, angles)
        layers.append([line.join(around) for line in lines])
    return list(map("".join, zip(*layers, strict=True)))


def _scalloped(centers: Floats, radii: Floats, lobes: int, turns: Floats) -> list[str]:
    """Closed lines of `lobes` arcs that bulge out of circles."""
    import numpy as np

    angles = turns[:, None] + 2 * math.pi / lobes * np.arange(lobes + 1)
    corners = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    points = centers[:, None] + radii[:, None, None] * corners
    separators = f" {_ARC}" * lobes + f" {_END}"
    lines = numbers_text(points.reshape(len(points), len(separators)), separators).split(_END)
    bulges = map(number, (1.15 * math.sin(math.pi / lobes) * radii).tolist())
    return [
        f"M{line.replace(_ARC, f'A{bulge} {bulge} 0 0 1 ')}Z"
        for line, bulge in zip(lines, bulges, strict=False)
    ]


_ARC, _END = "a", "z"
"""What stands for the arc before a corner, and for the end of a line."""
