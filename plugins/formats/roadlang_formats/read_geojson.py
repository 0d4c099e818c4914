"""`read with geojson`: lines of a GeoJSON file as streets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from .street_map import StreetMap

if TYPE_CHECKING:
    from pathlib import Path

    from roadlang.api import Diagnostic, DiagnosticError

    from .osm_reading.records import OsmWay


@dataclass(frozen=True)
class GeoJson(StreetMap):
    """The lines of a GeoJSON file as streets that meet where they share a point. The
    properties `lanes`, `oneway`, `maxspeed`, `building` and `name` work like the tags of
    OpenStreetMap."""

    name: ClassVar[str] = "geojson"
    suffixes: ClassVar[tuple[str, ...]] = (".geojson",)

    def read(self, path: Path) -> Any:
        """An `Extraction`. Raises RL479."""
        from .geojson_ways import ways_of
        from .json_maps import read_json
        from .map_xml import fault_at, left_out_at
        from .osm_reading.network import network_of_ways

        text, content = read_json(path)

        def fault(reason: str, help: str = "") -> DiagnosticError:
            return fault_at(path, text, 0, reason, help)

        def left_out(way: OsmWay, reason: str) -> Diagnostic:
            return left_out_at(path, text, way.offset, way.title, reason)

        options = self.street_options(service=True)
        return network_of_ways(ways_of(content, fault), options, fault, left_out)
