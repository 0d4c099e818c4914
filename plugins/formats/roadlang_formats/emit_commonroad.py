"""`emit commonroad`: lanelets, traffic rules, obstacles and a planning problem for planners."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene, Trace


@dataclass(frozen=True)
class CommonRoadBackend(RoadBackend):
    """Scenes as CommonRoad scenarios (2020a), with a planning problem for the ego. `roadlang run`
    writes the other agents as dynamic obstacles, as they were driven."""

    name: ClassVar[str] = "commonroad"

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .commonroad.document import document

        return {"cr.xml": document(scene)}

    def drive_files(self, scene: Scene, trace: Trace) -> Mapping[str, str]:
        from .commonroad.document import document

        return {"drive.cr.xml": document(scene, trace)}
