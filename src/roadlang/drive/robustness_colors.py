"""Colors of paths by robustness."""

from __future__ import annotations

from functools import cache

import numpy as np

from ..geometry.arrays import Floats

COLOR_STEPS = 8
"""Shades of robustness on each side of 0."""
OTHER = "#1c7ed6"
"""of paths of agents whose robustness is not shown"""
_SAFE, _EDGE, _FAILED = (47, 158, 68), (245, 159, 0), (201, 42, 42)


def color_shares(robustness: Floats) -> Floats:
    """(T,) robustness in parts of the largest of its sign, from -1 to 1 in steps of 1/8."""
    values = np.where(np.isnan(robustness), 0.0, robustness)
    finite = values[np.isfinite(values)]
    largest = np.max(finite, initial=1e-9), np.max(-finite, initial=1e-9)
    shares = np.clip(values / np.where(values > 0.0, *largest), -1.0, 1.0)
    return np.asarray(np.sign(shares) * np.ceil(np.abs(shares) * COLOR_STEPS) / COLOR_STEPS)


@cache
def robustness_color(share: float) -> str:
    """Green at 1, yellow at 0, red from -1/8 on."""
    end = _SAFE if share >= 0 else _FAILED
    weight = abs(share) ** 0.5 if share >= 0 else 1.0
    mixed = (round(e + (s - e) * weight) for e, s in zip(_EDGE, end, strict=True))
    return "#" + "".join(f"{value:02x}" for value in mixed)
