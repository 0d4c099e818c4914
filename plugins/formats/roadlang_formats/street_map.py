"""The options that all maps of streets have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from roadlang.api import ANGLE, Flag, Length, Reader, option, pair_of

from .place_on_earth import stated_origin

if TYPE_CHECKING:
    from .osm_reading.network import OsmOptions


@dataclass(frozen=True)
class StreetMap(Reader):
    """A map whose streets are lines between points in latitude and longitude."""

    reads: ClassVar[tuple[str, ...]] = ("network",)
    origin: Annotated[tuple[float, float], pair_of(ANGLE, ANGLE)] | None = option(
        None, help="latitude and longitude of (0, 0); by default the center of the streets"
    )
    lane_width: Length = option(3.25, minimum=2, maximum=6, help="width of every lane")
    traffic: Literal["right", "left"] = option(
        "right", help="driving side in the map; for left, also write `world { traffic: left }`"
    )
    buildings: Flag = option(False, help="whether buildings become objects")

    def __post_init__(self) -> None:
        """Raises RL480 for an origin that is not on Earth."""
        stated_origin(self.origin)

    def street_options(self, service: bool) -> OsmOptions:
        """As the network is made with them. `service`: with service roads."""
        from .osm_reading.network import OsmOptions

        origin = stated_origin(self.origin)
        return OsmOptions(origin, self.lane_width, self.traffic == "left", service, self.buildings)
