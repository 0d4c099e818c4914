"""`extract with contour`: the paper's chain, for clean pictures and drawings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Extractor, Flag, Length, Number, Pixels, Word, option

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture


@dataclass(frozen=True)
class Contour(Extractor):
    """Blur, threshold, contours, spline: a road that differs from all else by its tone."""

    name: ClassVar[str] = "contour"
    blur: Pixels = option(0.0, minimum=0, maximum=100, help="deviation of the Gaussian, first step")
    threshold: Number = option(
        "auto", words=("auto",), above=0, below=1, help="gray that parts road from the rest"
    )
    road: Word = option(
        "auto", words=("auto", "dark", "light"), help="which side of the threshold is road"
    )
    edges: Flag = option(True, help="read two edge lines as the road between them")
    spline: Flag = option(True, help="smooth the center lines")
    width: Length = option(None, above=0, help="the road's width, instead of the measured one")
    min_length: Length = option(
        None, minimum=0, help="shortest dead end that is kept; by default about the road's width"
    )

    def extract(self, picture: Picture) -> Extraction:
        from .extraction.contour import Chain, roads_by_contour
        from .extraction.pixels import pixels_of
        from .extraction.world import extraction

        chain = Chain(
            blur=self.blur,
            threshold=None if self.threshold == "auto" else float(self.threshold),
            road=self.road,
            between=self.edges,
            spline=self.spline,
            width=in_pixels(self.width, picture),
            min_length=in_pixels(self.min_length, picture),
        )
        found = roads_by_contour(pixels_of(picture, "contour"), chain)
        return extraction(picture, found)


def in_pixels(meters: Any, picture: Picture) -> float | None:
    """A length in pixels of the picture, None if it is not given."""
    return None if meters is None else float(meters) / picture.scale
