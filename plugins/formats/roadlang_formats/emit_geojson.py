"""`emit geojson`: roads, lanes, agents and objects for geographic information systems."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar

from roadlang.api import (
    ANGLE,
    Backend,
    Code,
    DiagnosticError,
    Flag,
    diagnose,
    option,
    pair_of,
)

from .place_on_earth import map_origin, stated_origin

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from roadlang.api import ScenarioContents, Scene


@dataclass(frozen=True)
class GeoJsonBackend(Backend):
    """Center lines, lanes, junctions, agents and objects of a scene in longitude and latitude, as
    GeoJSON. `read with geojson` reads the roads and buildings back."""

    name: ClassVar[str] = "geojson"
    also_called: ClassVar[tuple[str, ...]] = ("kml",)
    origin: Annotated[tuple[float, float], pair_of(ANGLE, ANGLE)] | None = option(
        None, help="latitude and longitude of (0, 0); by default that of the source map"
    )
    lanes: Flag = option(True, help="whether lanes and junctions are written as areas")

    def __post_init__(self) -> None:
        """Raises RL480 for an origin that is not on Earth."""
        stated_origin(self.origin)

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """It is of what has a place."""
        if not (contents.roads or contents.networks or contents.agents or contents.objects):
            yield "it has neither roads nor agents nor objects"

    def files(self, scene: Scene) -> Mapping[str, str]:
        """The collection. Raises DiagnosticError RL480 for a scene without a place on Earth."""
        from .geojson.document import document

        origin = stated_origin(self.origin) or map_origin(scene)
        if origin is None:
            raise DiagnosticError(
                diagnose(
                    Code.INVALID_OPTION,
                    option="origin",
                    kind="emit geojson",
                    reason="is missing, and the scene has no location from a map",
                    help="write latitude and longitude of (0, 0): "
                    "`emit geojson { origin: (48.137deg, 11.575deg) }`, on the command line"
                    " `--emit 'geojson{origin: (48.137deg, 11.575deg)}'`",
                )
            )
        return {"geojson": document(scene, origin, self.lanes)}
