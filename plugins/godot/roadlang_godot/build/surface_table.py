"""The surfaces of a world, as the engine has them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from roadlang.api import road_surface, surface_names

if TYPE_CHECKING:
    from roadlang.api import SurfaceName


def surface_number(name: SurfaceName | None) -> int:
    """That of a surface in the table; 0 for a road that says nothing of its surface."""
    return 0 if name is None else 1 + surface_names().index(name)


def surface_table(world: Mapping[str, Any]) -> list[tuple[float, float]]:
    """Friction and rolling resistance of all surfaces, in a scene with these settings."""
    table = [road_surface(world, name) for name in (None, *surface_names())]
    return [(surface.friction, surface.rolling) for surface in table]
