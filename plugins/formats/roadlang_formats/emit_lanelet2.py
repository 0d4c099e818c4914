"""`emit lanelet2`: lanelets and traffic rules for Lanelet2, Autoware and others."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar

from roadlang.api import ANGLE, Backend, option, pair_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from roadlang.api import ScenarioContents, Scene


@dataclass(frozen=True)
class Lanelet2Backend(Backend):
    """The roads of a scene as a Lanelet2 map: lanelets, line types, speed limits, right of way and
    traffic lights. Agents are not part of the format."""

    name: ClassVar[str] = "lanelet2"
    origin: Annotated[tuple[float, float], pair_of(ANGLE, ANGLE)] | None = option(
        None,
        help="latitude and longitude of (0, 0); by default that of the source map, else (0, 0)",
    )

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """It is of roads."""
        if not (contents.roads or contents.networks):
            yield "it has no road"

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .lanelet2.document import document

        at = None
        if self.origin is not None:
            at = math.degrees(self.origin[0]), math.degrees(self.origin[1])
        return {"lanelet2.osm": document(scene, at)}
