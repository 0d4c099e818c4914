"""Masks of roads as the world has them, of pictures whose up is not north."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...images.mapped_pixels import mapped
from ...ir.picture import Extraction, Picture


def with_upright_mask(found: Extraction, picture: Picture) -> Extraction:
    """What was found, its mask in the rows and columns of the upright rectangle around it."""
    if found.mask is None or picture.north_up is None:
        return found
    covered = found.mask.astype(np.uint8)
    return replace(found, mask=mapped(covered, picture.north_up, blends=False) > 0)
