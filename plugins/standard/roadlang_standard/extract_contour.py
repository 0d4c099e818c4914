"""`extract with contour`: the steps of the paper, for clean images and drawings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from roadlang.api import Extractor, Flag, Length, Number, OptionError, Pixels, Word, option

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture

    from .extraction.networks.found_network import FoundNetwork


@dataclass(frozen=True)
class Contour(Extractor):
    """Blur, threshold, contour, spline: for images where brightness sets the road apart."""

    name: ClassVar[str] = "contour"
    also_called: ClassVar[tuple[str, ...]] = ("opencv", "canny", "edges", "threshold", "edge")
    is_pure: ClassVar[bool] = True
    blur: Pixels = option(
        0.0, minimum=0, maximum=100, help="standard deviation of the Gaussian blur, the first step"
    )
    threshold: Number | Literal["auto"] = option(
        "auto",
        above=0,
        below=1,
        help="gray level that separates the road from the background",
    )
    road: Word = option(
        "auto",
        words=("auto", "dark", "light"),
        help="whether the road is darker or lighter than the background",
    )
    edges: Flag = option(True, help="read two edge lines as the road between them")
    spline: Flag = option(True, help="fit a smoothing spline to the center lines")
    width: Length | None = option(
        None, above=0, help="road width; measured in the image by default"
    )
    min_length: Length | None = option(
        None, minimum=0, help="minimum length of a dead end; by default about the road width"
    )

    def extract(self, picture: Picture) -> Extraction:
        from .extraction.pixels_to_meters import extraction

        return extraction(picture, self.found(picture))

    def found(self, picture: Picture) -> FoundNetwork:
        """The roads in pixels; `method` tells whether they lie between edge lines."""
        from .extraction.doubts.picture_doubts import with_picture_doubts
        from .extraction.drawings.thresholding import ContourSteps, roads_by_contour
        from .extraction.pixels import pixels_of

        chain = ContourSteps(
            blur=self.blur,
            threshold=None if self.threshold == "auto" else float(self.threshold),
            road=self.road,
            between=self.edges,
            spline=self.spline,
            width=road_width(self.width, picture),
            min_length=in_pixels(self.min_length, picture),
        )
        pixels = pixels_of(picture, "contour")
        return with_picture_doubts(roads_by_contour(pixels, chain), pixels, chain.width)


def in_pixels(meters: Any, picture: Picture) -> float | None:
    """A length in pixels of the picture, None if it is not given."""
    return None if meters is None else float(meters) / picture.scale


def road_width(meters: Any, picture: Picture) -> float | None:
    """The option `width` in pixels, None if it is not given.

    Raises OptionError for a road wider than the picture.
    """
    pixels, most = in_pixels(meters, picture), max(picture.width, picture.height)
    if pixels is not None and pixels > most:
        raise OptionError(
            "width",
            f"is {pixels:.4g} px at {picture.scale:g} m/px, but the picture has "
            f"{picture.width} x {picture.height} px",
        )
    return pixels
