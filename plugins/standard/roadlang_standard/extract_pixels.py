"""`extract with pixels`: text images and drawings with a legend, exactly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Extractor, Pixels, option

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture


@dataclass(frozen=True)
class Pixel(Extractor):
    """Text images and drawings: the legend says which characters or colors are roads or objects."""

    name: ClassVar[str] = "pixels"
    also_called: ClassVar[tuple[str, ...]] = ("legend", "tiles", "colors")
    is_pure: ClassVar[bool] = True
    thickness: Pixels | None = option(
        None,
        above=0,
        help="road width; by default the drawn width, or if all roads are drawn one cell wide, "
        "that of the lanes, at most one cell",
    )

    def extract(self, picture: Picture) -> Extraction:
        from .extraction.pixels import read_legend
        from .extraction.pixels_to_meters import extraction

        found, objects = read_legend(picture, self.thickness)
        return extraction(picture, found, objects)
