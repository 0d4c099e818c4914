"""`read with geojson`: lines of a GeoJSON file as streets."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from roadlang.api import ANGLE, Flag, Length, Reader, option, pair_of

if TYPE_CHECKING:
    from pathlib import Path

    from roadlang.api import DiagnosticError


@dataclass(frozen=True)
class GeoJson(Reader):
    """The lines of a GeoJSON file as streets that meet where they share a point. The
    properties `lanes`, `oneway`, `maxspeed` and `name` work like the tags of OpenStreetMap."""

    name: ClassVar[str] = "geojson"
    suffixes: ClassVar[tuple[str, ...]] = (".geojson",)
    reads: ClassVar[tuple[str, ...]] = ("network",)
    origin: Annotated[tuple[float, float], pair_of(ANGLE, ANGLE)] | None = option(
        None, help="latitude and longitude of (0, 0); by default the center of the streets"
    )
    lane_width: Length = option(3.25, minimum=2, maximum=6, help="width of every lane")
    traffic: Literal["right", "left"] = option(
        "right", help="driving side in the map; for left, also write `world { traffic: left }`"
    )
    buildings: Flag = option(
        False, help="whether polygons with a `building` property become objects"
    )

    def read(self, path: Path) -> Any:
        """An `Extraction`. Raises RL479."""
        from .geojson_ways import ways_of
        from .json_maps import read_json
        from .map_xml import fault_at
        from .osm_map.network import OsmOptions, network_of_ways

        text, content = read_json(path)

        def fault(reason: str, help: str = "") -> DiagnosticError:
            return fault_at(path, text, 0, reason, help)

        origin = None if self.origin is None else tuple(map(math.degrees, self.origin))
        left = self.traffic == "left"
        options = OsmOptions(origin, self.lane_width, left, True, self.buildings)  # type: ignore[arg-type]
        return network_of_ways(ways_of(content, fault), options, fault)
