"""`emit svg`: a figure of each scene, and a contact sheet."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend, Flag, ImageName, Number, Pixels, option

if TYPE_CHECKING:
    from roadlang.api import Scene


@dataclass(frozen=True)
class Svg(Backend):
    """A figure of each scene, and a contact sheet of all scenes."""

    name: ClassVar[str] = "svg"
    also_called: ClassVar[tuple[str, ...]] = ("png", "jpg", "pdf", "picture")
    is_default: ClassVar[bool] = True
    size: Pixels = option(1024.0, minimum=120, maximum=8192, help="width of the figure")
    ghost: Flag = option(True, help="show the original road under the perturbed one")
    labels: Flag = option(True, help="label agents and objects")
    legend: Flag = option(True, help="list requirements and expectations below the map")
    stations: Flag = option(True, help="mark arc length along the road")
    ids: Flag = option(True, help="write the ids of the junctions and roads of networks")
    profiles: Flag = option(True, help="plot signals and robustness over arc length")
    photo: ImageName | None = option(None, help="image to show under the roads")
    fade: Number = option(
        0.35, minimum=0, maximum=1, help="how much the photo is faded: 0 not at all, 1 to white"
    )
    contact_sheet: Flag = option(True, help="write contact-sheet.svg if there are several scenes")

    def files(self, scene: Scene) -> Mapping[str, str]:
        """The figure."""
        from .svg.drawing import Style, draw

        style = Style(
            self.size,
            self.ghost,
            self.labels,
            self.legend,
            self.stations,
            self.ids,
            self.profiles,
            self.photo,
            self.fade,
        )
        return {"svg": draw(scene, style)}

    def collection(self, scenes: Iterable[Scene]) -> Mapping[str, str]:
        """The contact sheet."""
        from .svg.sheet import contact_sheet

        sheet = contact_sheet(scenes, self.size) if self.contact_sheet else None
        return {} if sheet is None else {"contact-sheet.svg": sheet}
