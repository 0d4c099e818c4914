"""`extract with aerial`: roads in aerial photos, found by the bundled neural network."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import Extractor, Flag, Length, ListOf, Number, PixelPoint, Scale, option

from .extract_contour import in_pixels, road_width
from .photo_hints import (
    Box,
    boxes_in_picture,
    check_hints,
    check_only_through,
    roads_in_picture,
)

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture

    from .extraction.photos.road_net import Net


@dataclass(frozen=True)
class Aerial(Extractor):
    """Aerial photos: segment with a small neural network, trace, bridge gaps, find junctions."""

    name: ClassVar[str] = "aerial"
    also_called: ClassVar[tuple[str, ...]] = ("photo", "satellite", "segmentation")
    is_pure: ClassVar[bool] = True
    threshold: Number | Literal["auto"] = option(
        "auto", above=0, below=1, help="minimum probability of road"
    )
    width: Length | None = option(
        None, above=0, help="road width; measured in the image by default"
    )
    through: ListOf[PixelPoint] = option(
        (), help="pixels that a road passes through, in order along it"
    )
    leave_out: ListOf[Box] = option(
        (), help="boxes without roads, each given by two opposite corners"
    )
    only_through: Flag = option(False, help="keep only roads that contain a `through` point")
    min_length: Length | None = option(
        None, minimum=0, help="minimum length of a dead end; shorter ones are dropped"
    )
    method: Literal["learned", "classical"] = option(
        "learned",
        help="the bundled neural network, or classical ribbon filters",
    )
    resolution: Scale | Literal["auto", "unknown"] = option(
        "auto",
        above=0,
        help="assumed ground resolution; `auto` is the scale of the image",
    )

    def __post_init__(self) -> None:
        check_only_through(self.only_through, self.through)

    def extract(self, picture: Picture) -> Extraction:
        return self.read(picture)

    def read(self, picture: Picture, net: Net | None = None) -> Extraction:
        """Extract with a net, by default the shipped one."""
        from .extraction.photos.aerial import Request
        from .extraction.photos.cache import remembered
        from .extraction.photos.classical import roads_by_ribbons
        from .extraction.pixels import pixels_of
        from .extraction.pixels_to_meters import extraction

        check_hints(self.through, self.leave_out, picture)
        if self.method == "classical":
            return extraction(picture, roads_by_ribbons(pixels_of(picture, self.name)))
        resolution = {"auto": picture.scale, "unknown": None}.get(
            str(self.resolution), self.resolution
        )
        request = Request(
            threshold=None if self.threshold == "auto" else float(self.threshold),
            width=road_width(self.width, picture),
            through=roads_in_picture(self.through, picture),
            leave_out=boxes_in_picture(self.leave_out, picture),
            only_through=self.only_through,
            min_length=in_pixels(self.min_length, picture),
            meters_per_pixel=None if resolution is None else float(resolution),
        )
        return extraction(picture, remembered(pixels_of(picture, self.name), request, net))
