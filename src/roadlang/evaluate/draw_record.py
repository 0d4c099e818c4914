"""What was drawn while candidates were evaluated."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .candidate_rows import rows_of


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
    absent: dict[str, NDArray[np.bool_]] = field(default_factory=dict)
    """(V,) candidates that do not have a draw: those of copies that only others have"""

    def take(self, rows: NDArray[np.intp], count: int) -> DrawRecord:
        """What the candidates at `rows` of `count` have drawn."""
        absent = {name: rows_of(value, rows, count) for name, value in self.absent.items()}
        missing = {name for name, value in absent.items() if value.all()}
        coordinates, values = (
            {
                name: rows_of(value, rows, count)
                for name, value in found.items()
                if name not in missing
            }
            for found in (self.coordinates, self.values)
        )
        partly = {name: absent[name] for name in absent.keys() - missing if absent[name].any()}
        return DrawRecord(coordinates, values, partly)
