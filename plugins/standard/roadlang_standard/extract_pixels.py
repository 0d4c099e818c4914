"""`extract with pixels`: typed grids and drawings with a legend, exactly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Extractor, Pixels, option

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture


@dataclass(frozen=True)
class Pixel(Extractor):
    """Read a legend: a typed character, or a drawn color, is a road or an object."""

    name: ClassVar[str] = "pixels"
    thickness: Pixels = option(
        None, above=0, help="the roads' width; by default a cell, or what is drawn"
    )

    def extract(self, picture: Picture) -> Extraction:
        from .extraction.pixels import read_legend
        from .extraction.world import extraction

        found, things = read_legend(picture, self.thickness)
        return extraction(picture, found, things)
