"""What was drawn while candidates were evaluated."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class DrawRecord:
    """Filled by the `CandidateBatch` that it is passed to.

    Names are places of draws, with the number of the road or copy where there are several:
    `bent/perturb 1/amplitude`, `tree/at[2]`.
    """

    coordinates: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    """(V,) numbers in [0, 1) that draws and passes were made from"""
    values: dict[str, Any] = field(default_factory=dict)
    """(V, 1) what was drawn"""
