"""`read with osm`: the streets of an extract of OpenStreetMap."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from roadlang.api import ANGLE, Flag, Length, Reader, option, pair_of

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class OpenStreetMap(Reader):
    """The streets of an OpenStreetMap extract (`.osm`): lanes, one-way streets, speed limits.

    Coordinates are meters in the transverse Mercator projection around the origin.
    """

    name: ClassVar[str] = "osm"
    suffixes: ClassVar[tuple[str, ...]] = (".osm",)
    reads: ClassVar[tuple[str, ...]] = ("network",)
    origin: Annotated[tuple[float, float], pair_of(ANGLE, ANGLE)] | None = option(
        None, help="latitude and longitude of (0, 0); by default the center of the streets"
    )
    lane_width: Length = option(3.25, minimum=2, maximum=6, help="width of every lane")
    traffic: Literal["right", "left"] = option(
        "right", help="driving side in the map; for left, also write `world { traffic: left }`"
    )
    service: Flag = option(True, help="whether to include service roads, such as driveways")
    buildings: Flag = option(False, help="whether buildings become objects")

    def read(self, path: Path) -> Any:
        """An `Extraction`. Raises RL479."""
        from .map_xml import read_map_xml
        from .osm_map.network import OsmOptions, network_of

        origin = None if self.origin is None else tuple(map(math.degrees, self.origin))
        options = OsmOptions(
            origin,  # type: ignore[arg-type]
            self.lane_width,
            self.traffic == "left",
            self.service,
            self.buildings,
        )
        return network_of(read_map_xml(path, "osm"), options)
