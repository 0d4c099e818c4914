"""`extract with aerial`: roads in photos from above, found by the net that ships with roadlang."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Extractor, Length, Number, PixelPoint, list_of, option

from .extract_contour import in_pixels

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture


@dataclass(frozen=True)
class Aerial(Extractor):
    """A small learned net, then tracing, linking over gaps, junctions and widths."""

    name: ClassVar[str] = "aerial"
    threshold: Number = option(
        "auto", words=("auto",), above=0, below=1, help="least evidence along a road"
    )
    width: Length = option(None, above=0, help="the roads' width, instead of the measured one")
    through: list_of(PixelPoint) = option(  # type: ignore[valid-type]
        (), help="points that roads pass through"
    )
    leave_out: list_of(list_of(PixelPoint, at_least=2)) = option(  # type: ignore[valid-type]
        (), help="boxes without roads, each as two corners"
    )
    min_length: Length = option(None, minimum=0, help="shortest dead end that is kept")

    def extract(self, picture: Picture) -> Extraction:
        from .extraction.aerial import Request, roads_of_photo
        from .extraction.pixels import pixels_of
        from .extraction.world import extraction

        request = Request(
            threshold=None if self.threshold == "auto" else float(self.threshold),
            width=in_pixels(self.width, picture),
            through=tuple(self.through),
            leave_out=tuple(self.leave_out),
            min_length=in_pixels(self.min_length, picture),
            metres_per_pixel=picture.scale,
        )
        return extraction(picture, roads_of_photo(pixels_of(picture, "aerial"), request))
