"""Which roads and junctions of a scene are built, and which roads are loops."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneJunction, SceneRoad


def built_roads(scene: Scene) -> tuple[SceneRoad, ...]:
    """The last road of each chain and the edges of networks, but those inside of junctions."""
    swallowed = {
        name
        for network in scene.networks
        for junction in network.junctions
        for name in junction.inside
    }
    return tuple(road for road in scene.roads if road.derived and road.name not in swallowed)


def is_loop(road: SceneRoad) -> bool:
    """Whether no junction interrupts a closed road."""
    return road.closed and road.trim == (0.0, 0.0)


def built_junctions(scene: Scene) -> tuple[tuple[str, SceneJunction], ...]:
    """Junctions all of whose roads are built, each with the name of its network.

    Of a network that was perturbed on, only the last has such junctions.
    """
    names = {road.name for road in built_roads(scene)}
    return tuple(
        (network.name, junction)
        for network in scene.networks
        for junction in network.junctions
        if {arm.road for arm in junction.arms} <= names
    )
