"""`emit road_mask`: the surface of the roads from above, as a black and white picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend, Length, Scale, option

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from roadlang.api import ScenarioContents, Scene


@dataclass(frozen=True)
class RoadMaskBackend(Backend):
    """The road surface from above, white on black, north up, with a world file beside it. `extract
    with pixels` reads the network back from it, with the legend `"white": road`."""

    name: ClassVar[str] = "road_mask"
    also_called: ClassVar[tuple[str, ...]] = ("mask",)
    scale: Scale = option(0.25, minimum=0.01, maximum=100, help="meters per pixel")
    margin: Length = option(10.0, minimum=0, maximum=10000, help="around the roads")

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """It is of roads."""
        if not (contents.roads or contents.networks):
            yield "it has no road"

    def files(self, scene: Scene) -> Mapping[str, bytes | str]:
        """The picture, and where it lies. Raises DiagnosticError RL480 for too large a picture."""
        from .road_mask import road_mask

        mask = road_mask(scene, self.scale, self.margin)
        return {"mask.png": mask.png(), "mask.pgw": mask.world_file()}
