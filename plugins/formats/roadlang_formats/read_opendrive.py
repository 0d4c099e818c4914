"""`read with opendrive`: the network of an OpenDRIVE file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Flag, Reader, option

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class OpenDriveMap(Reader):
    """The roads, lanes and junctions of an ASAM OpenDRIVE file, 1.0 to 1.8. Roads keep their ids,
    and junctions keep their turns."""

    name: ClassVar[str] = "opendrive"
    suffixes: ClassVar[tuple[str, ...]] = (".xodr",)
    reads: ClassVar[tuple[str, ...]] = ("network",)
    objects: Flag = option(True, help="whether trees, poles, buildings and barriers are read")

    def read(self, path: Path) -> Any:
        """An `Extraction` in the coordinates of the file. Raises RL479."""
        from .map_xml import read_map_xml
        from .opendrive_reading.network import network_of

        return network_of(read_map_xml(path, "OpenDRIVE"), objects=self.objects)
