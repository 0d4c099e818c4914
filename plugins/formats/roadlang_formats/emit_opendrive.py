"""`emit opendrive`: roads, junctions, signals and objects for simulators that read OpenDRIVE."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import Length, String, option

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene


@dataclass(frozen=True)
class OpenDriveBackend(RoadBackend):
    """The roads, lanes, junctions, signals and objects of a scene as ASAM OpenDRIVE, which CARLA,
    esmini, SUMO and others read. Agents are not part of the format."""

    name: ClassVar[str] = "opendrive"
    also_called: ClassVar[tuple[str, ...]] = ("xodr",)
    version: Literal["1.6", "1.7", "1.8"] = option("1.8", help="of the format")
    tolerance: Length = option(
        0.005,
        minimum=0.0001,
        maximum=1,
        help="how far a reference line may be from the road where it is not exactly made of "
        "lines, arcs and clothoids",
    )
    geo_reference: String = option(
        "", help="a PROJ string that gives the location of the origin; by default none"
    )
    left_hand: Literal["one_way_roads", "rule"] = option(
        "one_way_roads",
        help="left-hand traffic: a road for each direction, which all tools drive, or roads with "
        '`rule="LHT"`, which CARLA, netconvert and Scenic do not support',
    )

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .opendrive.document import document

        text = document(scene, self.version, self.tolerance, self.geo_reference, self.left_hand)
        return {"xodr": text}
