"""`emit sbft`: road points for the SBFT tool competition."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend, Flag, Length, String, did_you_mean, option

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from roadlang.api import ScenarioContents, Scene, SceneRoad


_SHOWN = 8
"""Names of roads that an error lists."""


@dataclass(frozen=True)
class SbftBackend(Backend):
    """The road as a list of points `[[x, y], ...]` in meters, as tools of the SBFT tool competition
    (cyber-physical systems track) give it; `require N with sbft` evaluates the same points."""

    name: ClassVar[str] = "sbft"
    road: String = option(
        "", help="name of the road; without one, that of the first agent, or the last road made"
    )
    spacing: Length = option(
        5.0, minimum=1, maximum=50, help="distance between points, to the nearest that fits"
    )
    size: Length = option(200.0, minimum=50, maximum=10000, help="width and height of the map")
    centered: Flag = option(True, help="move the road to the middle of the map")

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """It is of one road, which has to be there."""
        named = self.road.partition("/")[0]  # a road of a network is `town/3`
        if not (contents.roads or contents.networks):
            yield "it has no road"
        elif self.road in contents.networks:
            yield f'`{self.road}` is a network: name one of its roads, as in `"{self.road}/ID"`'
        elif self.road and named not in (*contents.roads, *contents.networks):
            known = did_you_mean(named, (*contents.roads, *contents.networks))
            yield "; ".join((f"it has no road `{self.road}`", *known))

    def files(self, scene: Scene) -> Mapping[str, str]:
        import json

        import numpy as np

        from .sbft.road_points import road_points

        road = _road(scene, self.road)
        points = np.stack((road.x, road.y), axis=-1)[None]
        heading = np.array(road.heading)[None]
        ((_, found),) = road_points(points, heading, self.spacing, self.size, self.centered)
        return {"sbft.json": json.dumps(found[0].tolist()) + "\n"}


def _road(scene: Scene, name: str) -> SceneRoad:
    """The road of a name, of the first agent, or the last that was made."""
    from roadlang.api import Code, DiagnosticError, diagnose

    roads = {road.name: road for road in scene.roads}
    if name:
        if name not in roads:
            within = [known for known in roads if known.startswith(f"{name}/")]
            shown = ", ".join(f"`{known}`" for known in (within or list(roads))[:_SHOWN])
            raise DiagnosticError(
                diagnose(Code.UNKNOWN_NAME, name=name, help=f"roads of the scene: {shown}")
            )
        return roads[name]
    driven = next((actor.road for actor in scene.agents if actor.road in roads), None)
    if driven is not None:
        return roads[driven]
    derived = [road for road in scene.roads if road.derived] or list(scene.roads)
    return derived[-1]
