"""Values along the roads of a scene as numpy arrays: signals, and the robustness of formulas."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..geometry.arrays import Floats
    from ..ir.scene import Profile


def read_only(values: Any) -> Floats:
    """Numbers as an array that cannot be written to."""
    import numpy as np

    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array


@dataclass(frozen=True, eq=False)
class RoadProfile:
    """Values along one road."""

    road: str
    stations: Floats
    """(S,) arc length of the root road, meters"""
    values: Floats
    """(S,)"""

    def to_dict(self) -> dict[str, Floats]:
        """Columns for `pandas.DataFrame`."""
        return {"station": self.stations, "value": self.values}


class Profiles:
    """A signal, or the robustness of a formula, along each road that it is about.

    `text` is what it says, `unit` the SI unit of its values (empty for dimensionless numbers).
    """

    def __init__(self, name: str, text: str, unit: str, profiles: Iterable[Profile]) -> None:
        self.name = name
        self.text = text
        self.unit = unit
        self.roads: Mapping[str, RoadProfile] = MappingProxyType(
            {
                profile.road: RoadProfile(
                    profile.road, read_only(profile.stations), read_only(profile.values)
                )
                for profile in profiles
            }
        )

    def __repr__(self) -> str:
        return f"<{self.name}: {self.text} along {', '.join(self.roads)}>"

    @property
    def stations(self) -> Floats:
        """(S,) of the only road. Raises `ValueError` where there are several: see `roads`."""
        return self._only.stations

    @property
    def values(self) -> Floats:
        """(S,) of the only road. Raises `ValueError` where there are several: see `roads`."""
        return self._only.values

    @property
    def _only(self) -> RoadProfile:
        if len(self.roads) != 1:
            names = ", ".join(self.roads)
            raise ValueError(f"`{self.name}` is about several roads, name one in `roads`: {names}")
        return next(iter(self.roads.values()))
