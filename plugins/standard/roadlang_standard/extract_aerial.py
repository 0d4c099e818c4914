"""`extract with aerial`: roads in photos from above, found by the net that ships with roadlang."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Extractor, Flag, Length, Number, PixelPoint, Scale, Word, list_of, option

from .extract_contour import in_pixels

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture

    from .extraction.evidence import Net


@dataclass(frozen=True)
class Aerial(Extractor):
    """A small learned net, then tracing, linking over gaps, junctions and widths."""

    name: ClassVar[str] = "aerial"
    threshold: Number = option(
        "auto", words=("auto",), above=0, below=1, help="least evidence of a road"
    )
    width: Length = option(None, above=0, help="the roads' width, instead of the measured one")
    through: list_of(PixelPoint) = option(  # type: ignore[valid-type]
        (), help="points that roads pass through, in order along a road"
    )
    leave_out: list_of(list_of(PixelPoint, at_least=2)) = option(  # type: ignore[valid-type]
        (), help="boxes without roads, each as two corners"
    )
    only_through: Flag = option(False, help="keep only the roads that `through` points lie on")
    min_length: Length = option(None, minimum=0, help="shortest dead end that is kept")
    method: Word = option(
        "learned", words=("learned", "classical"), help="the shipped net, or ribbon filters alone"
    )
    resolution: Scale = option(
        "auto",
        words=("auto", "unknown"),
        above=0,
        help="ground resolution to reckon with; auto: the image's scale",
    )

    def extract(self, picture: Picture) -> Extraction:
        return self.read(picture)

    def read(self, picture: Picture, net: Net | None = None) -> Extraction:
        """Extract with a net, by default the shipped one."""
        from .extraction.aerial import Request
        from .extraction.cache import remembered
        from .extraction.classical import roads_by_ribbons
        from .extraction.pixels import pixels_of
        from .extraction.world import extraction

        if self.method == "classical":
            return extraction(picture, roads_by_ribbons(pixels_of(picture, self.name)))
        resolution = {"auto": picture.scale, "unknown": None}.get(
            str(self.resolution), self.resolution
        )
        request = Request(
            threshold=None if self.threshold == "auto" else float(self.threshold),
            width=in_pixels(self.width, picture),
            through=tuple(self.through),
            leave_out=tuple(tuple(box) for box in self.leave_out),
            only_through=self.only_through,
            min_length=in_pixels(self.min_length, picture),
            meters_per_pixel=None if resolution is None else float(resolution),
        )
        return extraction(picture, remembered(pixels_of(picture, self.name), request, net))
