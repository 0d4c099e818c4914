"""`emit scenic`: a Scenic program over the roads of a scene, with its agents and objects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Flag, String, option

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene

_MAP = "scenic.xodr"


@dataclass(frozen=True)
class ScenicBackend(RoadBackend):
    """A scene as a Scenic 3 program, with an OpenDRIVE map beside it: agents and objects have the
    poses of the scene, and may be made random again there."""

    name: ClassVar[str] = "scenic"
    model: String = option(
        "scenic.domains.driving.model", help="the world model, such as that of a simulator"
    )
    behaviors: Flag = option(
        True, help="whether agents get Scenic behaviors where these match their controllers"
    )

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .scenic.program import ScenicProgram
        from .scenic.road_map import road_map

        text, points = road_map(scene)
        name = f"{scene.stem}.{_MAP}"
        program = ScenicProgram(scene, self.model, self.behaviors, name, points)
        return {"scenic": program.text(), _MAP: text}
