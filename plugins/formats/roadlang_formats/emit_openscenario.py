"""`emit openscenario`: agents and what they do, for simulators that read OpenSCENARIO XML."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import option

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene, Trace

    from .openscenario.document import ScenarioFiles

_ROADS = "road.xodr"


@dataclass(frozen=True)
class OpenScenarioBackend(RoadBackend):
    """Scenes as ASAM OpenSCENARIO XML with their roads as OpenDRIVE, which esmini, CARLA's scenario
    runner and others play. `roadlang run` writes what was driven as trajectories."""

    name: ClassVar[str] = "openscenario"
    also_called: ClassVar[tuple[str, ...]] = ("xosc", "osc")
    version: Literal["1.2", "1.3"] = option("1.3", help="of the format")
    opendrive: Literal["1.6", "1.7", "1.8"] = option("1.8", help="version of the road file")

    def files(self, scene: Scene) -> Mapping[str, str]:
        writer = self._files(scene)
        return {_ROADS: writer.roads_text(self.opendrive), "xosc": writer.scenario_text()}

    def drive_files(self, scene: Scene, trace: Trace) -> Mapping[str, str]:
        writer = self._files(scene)
        return {_ROADS: writer.roads_text(self.opendrive), "drive.xosc": writer.drive_text(trace)}

    def _files(self, scene: Scene) -> ScenarioFiles:
        from .openscenario.document import ScenarioFiles

        return ScenarioFiles.of(scene, self.version, f"{scene.stem}.{_ROADS}")
