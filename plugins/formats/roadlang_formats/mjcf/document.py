"""A scene as the text of a MuJoCo model."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

import numpy as np

from roadlang.api import SceneActor, body_of, vehicle_parameters
from roadlang.geometry import Floats
from roadlang_standard.engine_tables import BODIES

from ..agent_paths import agent_path, lane_path
from ..surfaces.built import built_roads
from ..surfaces.heights import GROUND_BELOW, SceneHeights
from ..surfaces.junction_surface import junction_surfaces
from ..surfaces.prisms import junction_prisms, road_prisms
from ..surfaces.road_surface import road_surfaces
from ..target_speed import target_speed
from .car import put_car, put_controls, put_defaults, wheels_of
from .elements import put

if TYPE_CHECKING:
    from roadlang.api import Scene

_TOLERANCE = 0.02
"""Meters by which the edges of roads may be off."""
_DRY = 0.9
"""Friction where the world says nothing."""
_STEP = 0.004
_SPACING = 1.0
"""Meters between the points of a path."""
_SIZE = (4.5, 1.8, 1.5)
_BEGIN = 5.0
"""Meters from the start of the road to a car that is added."""
_LONG = 7.0
"""Meters: the wheels of longer vehicles do not turn far enough for tight turns of junctions."""
_SPEED = 12.0
"""m/s of such a car."""
_ROAD, _WALK, _GROUND = (0.19, 0.19, 0.2, 1), (0.46, 0.45, 0.43, 1), (0.28, 0.35, 0.18, 1)
_OBJECT, _OTHER = (0.55, 0.5, 0.42, 1), (0.7, 0.3, 0.2, 1)


def document(scene: Scene) -> str:
    """The model of a scene, with one car that can be driven."""
    friction = scene.world.get("friction")
    grip = float(friction) if isinstance(friction, (int, float)) else _DRY
    root = Element("mujoco", model=scene.title or scene.name)
    put(root, "compiler", angle="radian", autolimits="true")
    option = put(root, "option", timestep=_STEP, integrator="implicitfast", cone="elliptic")
    option.set("impratio", "10")
    visual = put(root, "visual")
    put(visual, "map", znear=0.001, zfar=10)
    defaults = put(root, "default")
    put_defaults(defaults)
    assets, world = put(root, "asset"), put(root, "worldbody")
    put(world, "light", pos=(0, 0, 100), dir=(-0.3, 0.2, -1), directional="true")
    _put_roads(scene, assets, world, grip)
    heights = SceneHeights.of(scene)
    driven = driven_agent(scene)
    for actor in scene.objects:
        _put_box(world, actor, heights.at_actor(actor), _OBJECT)
    for actor in scene.agents:
        if actor.name != driven.name:
            body = put(world, "body", name=actor.name, mocap="true")
            _put_pose(body, actor, heights.at_actor(actor))
            _put_box(body, replace(actor, x=0.0, y=0.0, heading=0.0), 0.0, _OTHER)
    put_car(world, driven, heights.at_actor(driven), grip)
    put_controls(root, driven, grip)
    _put_path(root, scene, driven)
    indent(root, " ")
    return tostring(root, encoding="unicode") + "\n"


def driven_agent(scene: Scene) -> SceneActor:
    """The agent `ego`, else the first vehicle, one that is not long if there is any, else a car at
    the start of a road."""
    vehicles = [actor for actor in scene.agents if not _walks(actor)]
    named = [actor for actor in vehicles if actor.name == "ego"]
    if vehicles:
        return (named or [actor for actor in vehicles if actor.length <= _LONG] or vehicles)[0]
    road = max(built_roads(scene), key=lambda road: road.length - sum(road.trim))
    section = road.cross_section()
    lane = (*section.driving_ids("forward"), *section.driving_ids(), *section.ids)[0]
    start = road.trim[0] + min(_BEGIN, 0.1 * (road.length - sum(road.trim)))
    points = lane_path(road, lane, start, 0.0, False)
    x, y = points[0].tolist()
    dx, dy = (points[1] - points[0]).tolist()
    length, width, height = _SIZE
    names = {actor.name for actor in scene.agents}
    name = next(name for name in ("ego", "ego car", "ego car 2") if name not in names)
    return SceneActor(
        name, name, "car", x, y, float(np.arctan2(dy, dx)), length, width, height,
        road=road.name, start=start, lane=lane, category="car",
    )  # fmt: skip


def _walks(actor: SceneActor) -> bool:
    return body_of(actor, BODIES).walks


def _put_roads(scene: Scene, assets: Element, world: Element, grip: float) -> None:
    tops = []
    for name, prism, raised in _prisms(scene):
        tops.append(float(prism[: len(prism) // 2, 2].min()))
        middle = np.round(prism.mean(axis=0), 1)
        corners = " ".join(f"{value:.4f}" for value in (prism - middle).ravel())
        put(assets, "mesh", name=name, vertex=corners, inertia="convex")
        geom = put(world, "geom", name=name, type="mesh", mesh=name, pos=middle.tolist())
        geom.set("rgba", " ".join(map(str, _WALK if raised else _ROAD)))
        geom.set("friction", f"{grip:.6g} 0.005 0.0001")
    ground = put(world, "geom", name="ground plane", type="plane", size=(0, 0, 10), rgba=_GROUND)
    ground.set("pos", f"0 0 {min(tops) - GROUND_BELOW:.6g}")
    ground.set("friction", f"{grip:.6g} 0.005 0.0001")


def _prisms(scene: Scene) -> Iterator[tuple[str, Floats, bool]]:
    """Names, corners, and whether it is a raised lane."""
    for surface in road_surfaces(scene, _TOLERANCE):
        for place, (prism, raised) in enumerate(road_prisms(surface)):
            yield f"{surface.road.name} {place}", prism, raised
    for area in junction_surfaces(scene):
        for place, prism in enumerate(junction_prisms(area)):
            yield f"{area.name} {place}", prism, False


def _put_box(parent: Element, actor: SceneActor, height: float, color: tuple[float, ...]) -> None:
    size = (actor.length / 2.0, actor.width / 2.0, actor.height / 2.0)
    geom = put(parent, "geom", name=actor.name, type="box", size=size, rgba=color)
    _put_pose(geom, actor, height + actor.height / 2.0)


def _put_pose(element: Element, actor: SceneActor, height: float) -> None:
    element.set("pos", f"{actor.x:.9g} {actor.y:.9g} {height:.9g}")
    element.set("euler", f"0 0 {actor.heading:.9g}")


def _put_path(root: Element, scene: Scene, driven: SceneActor) -> None:
    """What a driver has to know: the line to follow, the speed, and the sizes that matter."""
    custom = put(root, "custom")
    path = agent_path(scene, driven)
    if path is not None:
        steps = np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))))
        even = np.linspace(0.0, steps[-1], max(2, int(steps[-1] / _SPACING) + 1))
        x, y = (np.interp(even, steps, column) for column in path.T)
        put(custom, "numeric", name="path x", data=np.round(x, 4).tolist())
        put(custom, "numeric", name="path y", data=np.round(y, 4).tolist())
    speed = target_speed(scene, driven, driven.drive[0]) if driven.drive else _SPEED
    put(custom, "numeric", name="speed", data=(speed,))
    base = vehicle_parameters(driven, body_of(driven, BODIES)).wheelbase
    put(custom, "numeric", name="wheelbase", data=(base,))
    put(custom, "numeric", name="wheel radius", data=(wheels_of(driven, base).radius,))
