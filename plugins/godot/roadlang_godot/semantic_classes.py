"""The classes of semantic segmentation: their names and ids, and which kinds belong to each."""

from __future__ import annotations

from enum import IntEnum


class SemanticClass(IntEnum):
    """What a pixel shows. Ids do not change: new classes come at the end."""

    SKY = 0
    """nothing at all"""
    OTHER = 1
    TERRAIN = 2
    """grass and hills beside the road, medians of grass"""
    VEGETATION = 3
    ROAD = 4
    """lanes of every kind, junctions, and the lines between lanes"""
    ROAD_PAINT = 5
    """stop lines, arrows, crossings"""
    SIDEWALK = 6
    BUILDING = 7
    WALL = 8
    FENCE = 9
    BARRIER = 10
    POLE = 11
    TRAFFIC_SIGN = 12
    TRAFFIC_LIGHT = 13
    WATER = 14
    STREET_OBJECT = 15
    CONE = 16
    CAR = 17
    VAN = 18
    TRUCK = 19
    BUS = 20
    MOTORCYCLE = 21
    BICYCLE = 22
    OTHER_VEHICLE = 23
    PEDESTRIAN = 24
    ANIMAL = 25

    @property
    def label(self) -> str:
        """The name in files: `traffic_light`."""
        return self.name.lower()


_KINDS = {
    SemanticClass.VEGETATION: "tree bush hedge",
    SemanticClass.BUILDING: "building house bus_stop",
    SemanticClass.WALL: "wall",
    SemanticClass.FENCE: "fence guardrail",
    SemanticClass.BARRIER: "barrier",
    SemanticClass.POLE: "pole lamp bollard",
    SemanticClass.TRAFFIC_SIGN: "sign",
    SemanticClass.TRAFFIC_LIGHT: "traffic_light",
    SemanticClass.WATER: "water",
    SemanticClass.CONE: "cone",
    SemanticClass.CAR: "car taxi police_car parked_car",
    SemanticClass.VAN: "van ambulance parked_van",
    SemanticClass.TRUCK: "truck fire_truck parked_truck",
    SemanticClass.BUS: "bus parked_bus",
    SemanticClass.MOTORCYCLE: "motorcycle scooter parked_motorcycle",
    SemanticClass.BICYCLE: "bicycle parked_bicycle",
    SemanticClass.OTHER_VEHICLE: "tractor trailer",
    SemanticClass.PEDESTRIAN: "pedestrian child",
    SemanticClass.ANIMAL: "animal dog",
}
_BY_KIND = {kind: found for found, kinds in _KINDS.items() for kind in kinds.split()}


def class_of_kind(kind: str, default: SemanticClass) -> SemanticClass:
    """The class of a kind of agent or object; `default` of one that is not among the standard
    kinds."""
    return _BY_KIND.get(kind, default)


def class_table() -> dict[str, int]:
    """All names with their ids."""
    return {found.label: int(found) for found in SemanticClass}
