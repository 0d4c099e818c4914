"""`extract with onnx`: your own segmentation network in place of the bundled one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import File, option

from .extract_aerial import Aerial

if TYPE_CHECKING:
    from roadlang.api import Extraction, Picture


@dataclass(frozen=True, kw_only=True)
class OnnxExtractor(Aerial):
    """Your own network: RGB in 0..255 (1, 3, h, w) to one or two maps in 0..1 of half that size."""

    name: ClassVar[str] = "onnx"
    is_pure: ClassVar[bool] = False  # the file of the network may change
    model: File = option(
        help="ONNX file; outputs the road surface and, optionally, the center line"
    )

    def extract(self, picture: Picture) -> Extraction:
        from .extraction.photos.road_net import checked_net

        return self.read(picture, checked_net(self.model))
