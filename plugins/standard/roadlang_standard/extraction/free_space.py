"""Ways through free space: the middle lines of an area, as wide as it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .drawings.surface_roads import roads_of_surface
from .pixels_to_meters import extraction

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from roadlang.api import Extraction


def roads_of_free_space(
    free: NDArray[np.bool_], resolution: float, width: float | None, smallest: float
) -> Extraction:
    """The network of (height, width) free cells of `resolution` m/px.

    `width` in meters is that of all roads where it is given. Areas and holes smaller than a
    square of `smallest` meters are noise. Areas that touch the border are open there.
    """
    from roadlang.api import Picture

    found = roads_of_surface(
        free.astype(np.float32),
        "free space",
        width=None if width is None else width / resolution,
        specks=max(2.0, (smallest / resolution) ** 2),
    )
    pixels = np.repeat(free[..., None], 3, axis=2).astype(np.uint8) * 255
    return extraction(Picture(pixels, resolution), found)
