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


_CATEGORIES = {
    "tree": SemanticClass.VEGETATION,
    "bush": SemanticClass.VEGETATION,
    "hedge": SemanticClass.VEGETATION,
    "building": SemanticClass.BUILDING,
    "shelter": SemanticClass.BUILDING,
    "wall": SemanticClass.WALL,
    "fence": SemanticClass.FENCE,
    "guardrail": SemanticClass.FENCE,
    "barrier": SemanticClass.BARRIER,
    "pole": SemanticClass.POLE,
    "lamp": SemanticClass.POLE,
    "sign": SemanticClass.TRAFFIC_SIGN,
    "traffic_light": SemanticClass.TRAFFIC_LIGHT,
    "water": SemanticClass.WATER,
    "cone": SemanticClass.CONE,
    "obstacle": SemanticClass.STREET_OBJECT,
    "car": SemanticClass.CAR,
    "van": SemanticClass.VAN,
    "truck": SemanticClass.TRUCK,
    "bus": SemanticClass.BUS,
    "motorcycle": SemanticClass.MOTORCYCLE,
    "bicycle": SemanticClass.BICYCLE,
    "tractor": SemanticClass.OTHER_VEHICLE,
    "trailer": SemanticClass.OTHER_VEHICLE,
    "pedestrian": SemanticClass.PEDESTRIAN,
    "animal": SemanticClass.ANIMAL,
}


def class_of_category(category: str) -> SemanticClass:
    """The class of agents and objects of a category."""
    return _CATEGORIES.get(category, SemanticClass.OTHER)


def class_table() -> dict[str, int]:
    """All names with their ids."""
    return {found.label: int(found) for found in SemanticClass}
