"""`read with osm`: the streets of an extract of OpenStreetMap."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Flag, option

from .street_map import StreetMap

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class OpenStreetMap(StreetMap):
    """The streets of an OpenStreetMap extract (`.osm`): lanes, one-way streets, speed limits.

    Coordinates are meters in the transverse Mercator projection around the origin.
    """

    name: ClassVar[str] = "osm"
    suffixes: ClassVar[tuple[str, ...]] = (".osm",)
    service: Flag = option(True, help="whether to include service roads, such as driveways")

    def read(self, path: Path) -> Any:
        """An `Extraction`. Raises RL479."""
        from .map_xml import read_map_xml
        from .osm_reading.network import network_of

        options = self.street_options(self.service)
        return network_of(read_map_xml(path, "osm"), options)
