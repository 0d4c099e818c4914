"""Materials of what is built: base color, roughness and metalness."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from roadlang.geometry import Lane
from roadlang_standard.extraction.colors.colors import bgr
from roadlang_standard.lane_looks import PAINT, LaneLook, lane_look


@dataclass(frozen=True)
class Material:
    """`color` is sRGB, `#rrggbb` or a name, which glTF wants in linear light."""

    name: str
    color: str
    roughness: float = 0.9
    metallic: float = 0.0

    def record(self) -> dict[str, Any]:
        """As glTF has it."""
        blue, green, red = bgr(self.color)
        return {
            "name": self.name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*(_linear(part / 255.0) for part in (red, green, blue)), 1.0],
                "metallicFactor": self.metallic,
                "roughnessFactor": self.roughness,
            },
        }


def _linear(value: float) -> float:
    """A component of sRGB in linear light (IEC 61966-2-1)."""
    low = value <= 0.04045
    return round(value / 12.92 if low else ((value + 0.055) / 1.055) ** 2.4, 6)


def srgb(linear: float) -> float:
    """A component in linear light in sRGB: the inverse."""
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


_SHARED = (
    Material("asphalt", LaneLook.ROADWAY.color),
    Material("bus lane", LaneLook.BUS.color),
    Material("bike lane", LaneLook.BIKE.color),
    Material("parking", LaneLook.PARKING.color),
    Material("sidewalk", LaneLook.SIDEWALK.color),
    Material("grass", LaneLook.GRASS.color, 1.0),
    Material("curb", "#8c8a82"),
    Material("ground", "#47592e", 1.0),
    Material("embankment", "#4d4a33", 1.0),
    Material("paint", PAINT, 0.7),
    Material("glass", "#0d1217", 0.1, 0.4),
    Material("tire", "#0d0d0d"),
    Material("metal", "#595c61", 0.5, 0.6),
    Material("trunk", "#4d3826"),
    Material("roof", "#544d4d"),
    Material("skin", "#c99b7c"),
    Material("red light", "#c62828", 0.4),
    Material("yellow light", "#f9a825", 0.4),
    Material("green light", "#2e7d32", 0.4),
)
MATERIALS: Mapping[str, Material] = {material.name: material for material in _SHARED}
"""By name."""
_LANES = {
    LaneLook.ROADWAY: "asphalt",
    LaneLook.PLAIN: "asphalt",
    LaneLook.BUS: "bus lane",
    LaneLook.BIKE: "bike lane",
    LaneLook.PARKING: "parking",
    LaneLook.SIDEWALK: "sidewalk",
    LaneLook.GRASS: "grass",
}


def lane_material(lane: Lane) -> str:
    """The name of the material of a lane."""
    return _LANES[lane_look(lane)]


def painted(kind: str, color: str) -> Material:
    """Of an agent or object in its color; gray, if that is none."""
    try:
        bgr(color)
    except ValueError:
        color = "gray"
    return Material(f"{kind} {color}", color, 0.5)
