"""The colors of roads and things in figures, of scenes and of drives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..ir.category import BUILDING, GREENERY
from ..ir.scene_surface import SurfaceName

_SURFACES: Mapping[SurfaceName | None, str] = {
    "wet": "#56626f",
    "snow": "#dfe4ea",
    "ice": "#b7d3e2",
    "gravel": "#a3937c",
    "turf": "#a9bd8c",
}


@dataclass(frozen=True)
class FigureColors:
    """Calm ground, gray roads: as SVG writes colors."""

    ground: str = "#f4f2ec"
    surface: str = "#757b83"
    """of what is driven on"""
    raised: str = "#b9b6ac"
    """of lanes behind a curb"""
    beside: str = "#868b92"
    """of other lanes that are not driven on"""
    marking: str = "#fbfaf5"
    faint_marking: str = "#b9bcbf"
    """of crossings too small to see their stripes"""
    curb: str = "#dedace"
    ink: str = "#23272b"
    thing: str = "#c9a227"
    """of objects without a color of their own"""
    leaves: str = "#5d9550"
    roof: str = "#b98b6e"

    def of_lane(self, *, drivable: bool, raised: bool) -> str:
        """Of a lane whose kind says nothing else. Figures of drives know no kinds."""
        if drivable:
            return self.surface
        return self.raised if raised else self.beside

    def of_surface(self, name: SurfaceName | None) -> str | None:
        """Of what covers a lane; None for asphalt, and where the road says nothing."""
        return _SURFACES.get(name)


FIGURE_COLORS = FigureColors()


def object_color(category: str) -> str:
    """Of an object seen from above."""
    if category in GREENERY:
        return FIGURE_COLORS.leaves
    return FIGURE_COLORS.roof if category == BUILDING else FIGURE_COLORS.thing
