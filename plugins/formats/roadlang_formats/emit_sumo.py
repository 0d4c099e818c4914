"""`emit sumo`: the network, the traffic and a configuration for SUMO."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Duration, Flag, option

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene, Trace


@dataclass(frozen=True)
class SumoBackend(RoadBackend):
    """Scenes as networks of SUMO with signals, vehicles and their routes: `sumo -c
    scene-0000.sumocfg` runs one. `roadlang run` writes drives as floating car data."""

    name: ClassVar[str] = "sumo"
    also_called: ClassVar[tuple[str, ...]] = ("net",)
    step: Duration = option(0.1, minimum=0.01, maximum=1, help="time step in the configuration")
    objects: Flag = option(False, help="whether objects are written, as polygons")

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .sumo.configuration import configuration_text
        from .sumo.network import SumoNetwork
        from .sumo.routes import routes_text, trips_of, walks_of

        network = SumoNetwork.of(scene)
        found = {
            "net.xml": network.text(),
            "rou.xml": routes_text(trips_of(scene, network), walks_of(scene, network)),
        }
        if self.objects and scene.objects:
            from .sumo.polygons import polygons_text

            found["add.xml"] = polygons_text(scene.objects)
        additional = f"{scene.stem}.add.xml" if "add.xml" in found else None
        names = [f"{scene.stem}.{ending}" for ending in ("net.xml", "rou.xml")]
        found["sumocfg"] = configuration_text(names[0], names[1], additional, self.step)
        return found

    def drive_files(self, scene: Scene, trace: Trace) -> Mapping[str, str]:
        from .sumo.drive import drive_text

        return {"fcd.xml": drive_text(scene, trace)}
