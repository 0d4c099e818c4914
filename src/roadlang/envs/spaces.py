"""The space of actions, and what is checked of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.spaces import Box, Space
from numpy.typing import NDArray

from ..geometry.arrays import Floats

ACTIONS: Space[NDArray[np.float32]] = Box(-1.0, 1.0, (2,), np.float32)
"""Steering (1: all the way to the left) and acceleration (-1: brakes)."""


def checked_actions(actions: Any, *shape: int) -> Floats:
    """Actions within -1 and 1. Raises ValueError for what is no numbers, another shape, and NaN."""
    try:
        found = np.asarray(actions, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"actions must be numbers, not {actions!r}") from None
    if found.shape != shape:
        raise ValueError(f"actions must have the shape {shape}, not {found.shape}")
    if np.isnan(found).any():
        raise ValueError("an action is not a number")
    return np.minimum(np.maximum(found, -1.0), 1.0)
