"""`emit lanelet2`: lanelets and traffic rules for Lanelet2, Autoware and others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar

from roadlang.api import ANGLE, option, pair_of

from .place_on_earth import stated_origin
from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene


@dataclass(frozen=True)
class Lanelet2Backend(RoadBackend):
    """The roads of a scene as a Lanelet2 map: lanelets, line types, speed limits, right of way and
    traffic lights. Agents are not part of the format."""

    name: ClassVar[str] = "lanelet2"
    origin: Annotated[tuple[float, float], pair_of(ANGLE, ANGLE)] | None = option(
        None,
        help="latitude and longitude of (0, 0); by default that of the source map, else (0, 0)",
    )

    def __post_init__(self) -> None:
        """Raises RL480 for an origin that is not on Earth."""
        stated_origin(self.origin)

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .lanelet2.document import document

        return {"lanelet2.osm": document(scene, stated_origin(self.origin))}
