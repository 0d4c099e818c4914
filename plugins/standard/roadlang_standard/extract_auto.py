"""`extract with auto`, the default: detect the type of image and use the matching extractor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import Extractor, Flag, Length, ListOf, Number, PixelPoint, Scale, option

from .photo_hints import Box, check_hints, check_only_through

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture

    from .extract_aerial import Aerial
    from .extraction.networks.found_network import FoundNetwork
    from .extraction.picture_kinds.picture_kind import PictureKind

_DOUBTFUL, _SURE = 0.5, 0.9
"""What is less than `_DOUBTFUL` as a map is a drawing of few colors, such as a slide, if it is more
than `_SURE` as one."""
_UNUSED_BOXES = (
    "`leave_out` is for photos and was ignored: use `extract with aerial` to read this picture as a"
    " photo, or `dismissed` of the network to remove roads"
)


@dataclass(frozen=True)
class Auto(Extractor):
    """Detect the type of image (photo, drawing, mask, legend) and use the matching extractor."""

    name: ClassVar[str] = "auto"
    also_called: ClassVar[tuple[str, ...]] = ("map", "drawing", "mask")
    is_pure: ClassVar[bool] = True
    is_default: ClassVar[bool] = True
    threshold: Number | Literal["auto"] = option(
        "auto", above=0, below=1, help="threshold of `aerial` or `contour`"
    )
    width: Length | None = option(
        None, above=0, help="road width; measured in the image by default"
    )
    through: ListOf[PixelPoint] = option((), help="pixels that a road passes through (photos only)")
    leave_out: ListOf[Box] = option(
        (), help="boxes without roads, each given by two opposite corners (photos only)"
    )
    only_through: Flag = option(False, help="keep only roads that contain a `through` point")
    resolution: Scale | Literal["auto", "unknown"] = option(
        "auto",
        above=0,
        help="assumed ground resolution of a photo; `auto` is the scale of the image",
    )

    def __post_init__(self) -> None:
        check_only_through(self.only_through, self.through)

    def extract(self, picture: Picture) -> Extraction:
        from dataclasses import replace

        from .extract_contour import road_width
        from .extract_pixels import Pixel
        from .extraction.colors.picture_memo import measuring_once

        check_hints(self.through, self.leave_out, picture)
        if picture.characters is not None or picture.legend:
            kind = "typed grid" if picture.characters is not None else "drawing with a legend"
            found = Pixel(thickness=road_width(self.width, picture)).extract(picture)
        else:
            with measuring_once():
                kind, found = self._seen(picture)
        article = "an" if kind[0] in "aeiou" else "a"
        unused = (_UNUSED_BOXES,) if self.leave_out and kind != "photo" else ()
        return replace(found, remarks=(f"read as {article} {kind}", *unused, *found.remarks))

    def _seen(self, picture: Picture) -> tuple[str, Extraction]:
        """What sort of picture without a legend it is, and its roads."""
        from dataclasses import replace

        from .extract_aerial import Aerial
        from .extract_contour import road_width
        from .extraction.doubts.picture_doubts import with_picture_doubts
        from .extraction.drawings.screen_grid import without_grid
        from .extraction.maps.map_tiles import roads_of_map
        from .extraction.paper.paper import roads_on_paper
        from .extraction.picture_kinds.picture_kind import MAP, MASK, picture_kind
        from .extraction.pixels_to_meters import extraction

        assert picture.pixels is not None
        picture = replace(picture, pixels=without_grid(picture.pixels))
        assert picture.pixels is not None
        seen, width = picture_kind(picture.pixels), road_width(self.width, picture)
        if self.threshold == "auto" and not self.through and not seen.named(MASK):
            on_paper = None if seen.exact else roads_on_paper(picture.pixels, width, not seen.drawn)
            if on_paper is not None:
                on_paper = with_picture_doubts(on_paper, picture.pixels, width)
                return "drawing on paper", extraction(picture, on_paper)
            rendered = None
            if seen.drawn:
                rendered = roads_of_map(picture.pixels, width, lambda: seen.is_plan)
            if rendered is not None:
                rendered = with_picture_doubts(rendered, picture.pixels, width)
                kind, found = "rendered map", rendered
                if rendered.confidence < _DOUBTFUL and not seen.named(MAP):
                    other, drawn = self._drawn(seen, picture)
                    if drawn.confidence > _SURE:
                        kind, found = other, drawn
                return kind, with_legend_proposed(picture, extraction(picture, found))
        if seen.drawn and not self.through:
            kind, found = self._drawn(seen, picture)
            return kind, with_legend_proposed(picture, extraction(picture, found))
        return seen.name, self._aerial(Aerial).extract(picture)

    def _drawn(self, seen: PictureKind, picture: Picture) -> tuple[str, FoundNetwork]:
        """What sort of drawing it is, and its roads."""
        from .extract_contour import Contour, road_width
        from .extraction.doubts.picture_doubts import with_picture_doubts
        from .extraction.drawings.drawing import roads_of_drawing
        from .extraction.networks.found_network import EDGE_LINES
        from .extraction.picture_kinds.picture_kind import EDGES, FILLED, MAP

        assert picture.pixels is not None
        if self.threshold == "auto" and seen.named(MAP):
            width = road_width(self.width, picture)
            colored = roads_of_drawing(picture.pixels, width=width)
            return MAP, with_picture_doubts(colored, picture.pixels, width)
        found = Contour(threshold=self.threshold, width=self.width).found(picture)
        if seen.unless_edges != FILLED:
            return seen.name, found
        return EDGES if found.method == EDGE_LINES else FILLED, found

    def _aerial(self, kind: type[Aerial]) -> Aerial:
        """The photo's kind with this one's options."""
        return kind(
            threshold=self.threshold,
            width=self.width,
            through=self.through,
            leave_out=self.leave_out,
            only_through=self.only_through,
            resolution=self.resolution,
        )


def with_legend_proposed(picture: Picture, found: Extraction) -> Extraction:
    """With a remark on colors of a drawing that may be objects."""
    from dataclasses import replace

    from .extraction.legends.legend_proposal import legend_proposal

    if found.mask is None or picture.pixels is None:
        return found
    proposal = legend_proposal(picture.pixels, found.mask)
    return found if proposal is None else replace(found, remarks=(*found.remarks, proposal))
