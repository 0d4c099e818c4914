"""What roads and the ground beside them are made of: grip and rolling resistance, in any engine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...ir.scene_surface import SURFACE_NAMES, SurfaceName


@dataclass(frozen=True)
class TireSurface:
    """`friction` of a tire on it, at most; `rolling`: resistance to rolling for each newton of
    weight, in addition to that of the vehicle on a hard road."""

    friction: float
    rolling: float = 0.0


SURFACES: Mapping[SurfaceName, TireSurface] = {
    "asphalt": TireSurface(0.9),
    "wet": TireSurface(0.6),
    "snow": TireSurface(0.3, 0.02),
    "ice": TireSurface(0.1),
    "gravel": TireSurface(0.6, 0.015),
    "turf": TireSurface(0.45, 0.06),
}
"""By name. Typical peak friction and rolling resistance of passenger cars: J. Y. Wong, Theory of
Ground Vehicles, tables 1.2 and 1.5."""
BESIDE = SURFACES["turf"]
"""What is beside roads."""
LEAST_FRICTION = 1e-3
"""What is slipperier counts as this: tire forces divide by friction."""
_AFTER: Mapping[str, SurfaceName] = {"rain": "wet", "snow": "snow"}


def surface_names() -> tuple[SurfaceName, ...]:
    """Of all surfaces, always in the same order."""
    return SURFACE_NAMES


def road_surface(world: Mapping[str, Any], name: SurfaceName | None = None) -> TireSurface:
    """A road of a scene with these settings of its `world`, that says nothing of its surface or is
    of the surface with this `name`.

    Weather makes a road wet or snowy, and `friction` is that of its roads. No surface has more
    grip than the roads that say nothing.
    """
    weather: SurfaceName = _AFTER.get(str(world.get("weather")), "asphalt")
    if weather == "asphalt" and _is_number(world.get("rain")) and world["rain"] > 0.0:
        weather = "wet"
    usual = SURFACES[weather]
    if _is_number(world.get("friction")):
        usual = TireSurface(max(float(world["friction"]), LEAST_FRICTION), usual.rolling)
    return usual if name is None else below(SURFACES[name], usual)


def below(surface: TireSurface, usual: TireSurface) -> TireSurface:
    """A surface where roads that say nothing of theirs are `usual`."""
    friction = min(surface.friction, usual.friction)
    return TireSurface(friction, max(surface.rolling, usual.rolling))


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
