"""Which junctions a figure shows, given its roads."""

from __future__ import annotations

from ..ir.scene import Scene
from ..ir.scene_junctions import SceneJunction


def shown_junctions(scene: Scene, names: set[str]) -> list[SceneJunction]:
    """The junctions all of whose roads are drawn; `names`: of the roads that are."""
    return [
        junction
        for network in scene.networks
        for junction in network.junctions
        if names.issuperset(arm.road for arm in junction.arms)
    ]
