"""What lanes of each kind look like in space: for engines and meshes the same."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import geometry

PAINT = "#dbdbd1"
"""Of all that is painted on roads, sRGB"""


class LaneLook(IntEnum):
    """A surface. Its number is that of the Godot project (`build/looks.gd`)."""

    ROADWAY = 0
    PLAIN = 1
    """paved, without the tracks of wheels"""
    BUS = 2
    BIKE = 3
    PARKING = 4
    SIDEWALK = 5
    GRASS = 6

    @property
    def color(self) -> str:
        """sRGB, as `#rrggbb`."""
        return _COLORS[self]


_COLORS = {
    LaneLook.ROADWAY: "#404042",
    LaneLook.PLAIN: "#404042",
    LaneLook.BUS: "#3d3330",
    LaneLook.BIKE: "#542621",
    LaneLook.PARKING: "#47474a",
    LaneLook.SIDEWALK: "#75736e",
    LaneLook.GRASS: "#334d1f",
}
_OF_KIND = {
    "bus": LaneLook.BUS,
    "bike": LaneLook.BIKE,
    "parking": LaneLook.PARKING,
    "shoulder": LaneLook.PLAIN,
    "sidewalk": LaneLook.SIDEWALK,
    "median": LaneLook.SIDEWALK,
    "grass": LaneLook.GRASS,
}


def lane_look(lane: geometry.Lane) -> LaneLook:
    """Of a kind that a plugin brings: as a sidewalk if it is raised, else as a roadway or, where
    nobody drives, plain."""
    known = _OF_KIND.get(lane.kind)
    if known is not None:
        return known
    if lane.raised:
        return LaneLook.SIDEWALK
    return LaneLook.ROADWAY if lane.drivable else LaneLook.PLAIN
