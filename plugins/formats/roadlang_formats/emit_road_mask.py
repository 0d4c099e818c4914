"""`emit road_mask`: the surface of the roads from above, as a black and white picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Length, Scale, option

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene


@dataclass(frozen=True)
class RoadMaskBackend(RoadBackend):
    """The road surface from above, white on black, north up, with a world file beside it. `extract
    with pixels` reads the network back from it, with the legend `"white": road`."""

    name: ClassVar[str] = "road_mask"
    also_called: ClassVar[tuple[str, ...]] = ("mask",)
    scale: Scale = option(0.25, minimum=0.01, maximum=100, help="meters per pixel")
    margin: Length = option(10.0, minimum=0, maximum=10000, help="around the roads")

    def files(self, scene: Scene) -> Mapping[str, bytes | str]:
        """The picture, and where it lies. Raises DiagnosticError RL480 for too large a picture."""
        from .road_mask import road_mask

        mask = road_mask(scene, self.scale, self.margin)
        return {"mask.png": mask.png(), "mask.pgw": mask.world_file()}
