"""`read with ros_map`: the free space of a ROS map as a network."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Length, Reader, option

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path


@dataclass(frozen=True)
class RosMap(Reader):
    """The center lines of the free space of a ROS map (`map.yaml` and its image)."""

    name: ClassVar[str] = "ros_map"
    suffixes: ClassVar[tuple[str, ...]] = (".yaml", ".yml")
    reads: ClassVar[tuple[str, ...]] = ("network",)
    width: Length = option(None, above=0, help="road width; by default that of the free space")
    smallest: Length = option(
        0.5, minimum=0, help="side of the smallest area that is kept; smaller ones are noise"
    )

    def read(self, path: Path) -> Any:
        """An `Extraction` in the map's frame: meters, the origin as the map has it."""
        from roadlang_standard.ros_map import read_map

        from .extraction.free_space import roads_of_free_space

        found = read_map(path)
        extraction = roads_of_free_space(found.free, found.resolution, self.width, self.smallest)
        return found.placed(extraction)

    def companions(self, path: Path) -> Iterable[str]:
        """The image of the map."""
        from roadlang_standard.ros_map import read_record

        return [read_record(path).image]
