"""A scene as things to send: which roads are built, who drives where, and what stands beside."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from roadlang.api import Code, junction_surface

from ..faults import fault
from ..net.scene_part import ScenePart
from .agent_looks import look_of, object_color
from .agent_specs import AgentPose, agent_spec, followed_lines, kept_start
from .camera_parts import camera_parts
from .drives import undriven_agents
from .frame import SceneOrigin, extent_from, frame_around
from .junction_parts import paint_parts, signal_parts
from .junction_sidewalks import sidewalk_parts
from .junctions import RoadArm, area_patch, cuts, order, patch
from .line import RoadSamples, line_of
from .mask_tiles import network_tiles
from .mounted_camera import cameras_of
from .names import plain_name
from .placed import Placed, agent_part, object_parts, path_parts, world_part
from .road_mesh import road_parts
from .surface_table import surface_number

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, SceneJunction, SceneNetwork, SceneRoad

BESIDE = 150.0
"""Flat ground around everything, meters."""
GROWTH = 200.0
"""Meters by which the ground grows at once where an edit moves a road beyond it."""
LEVEL, MOST_LEVELS = 0.005, 6
"""Meters from one crossing road to the next above it, and after how many it begins again."""
MOSTLY = 0.9
"""Share of a road that lies on a network, from which on it is a way through the network."""


@dataclass(frozen=True, slots=True)
class Layout:
    """All that is sent of one scene. `agents` maps names to the engine's numbers."""

    name: str
    parts: tuple[ScenePart, ...]
    frame: SceneOrigin
    extent: float
    agents: Mapping[str, int]
    paths: Mapping[str, int]
    objects: Mapping[int, tuple[str, ...]]
    """names of the objects that a thing holds, by its id"""
    specs: Mapping[str, Mapping[str, Any]]
    """of the agents, as sent"""
    grown: bool
    """whether edits have moved roads beyond the ground that the scene began with"""
    undriven: tuple[str, ...]
    """agents whose controllers the engine does not have, and that Python does not drive"""

    def settings(self, ticks: int = 60) -> dict[str, Any]:
        """What a scene begins with."""
        name = self.name.encode("ascii", "replace").decode()
        return {"name": name, "extent": round(self.extent + BESIDE, 1), "ticks": ticks}


def layout_of(
    scene: Scene,
    road: str = "mesh",
    python_driven: Collection[str] = (),
    earlier: Layout | None = None,
    restarted: Collection[str] = (),
    poses: Mapping[str, AgentPose] | None = None,
) -> Layout:
    """The layout of a scene with roads built as a `mesh` along their curves or as `tiles`.

    Of agents that are `python_driven`, no controllers are sent. `earlier`: the layout before an
    edit, whose frame and numbers stay, so that what did not move is not sent again; of its agents,
    those begin anew that are `restarted`, by their names or groups, at one of the `poses` where
    there is one.

    Raises `EngineError` RL509 where there is no road, RL514 where tiles have no pixels.
    """
    lines = {road.name: line_of(road) for road in scene.roads}
    built = built_roads(scene, lines)
    if not built:
        raise fault(Code.NO_ROAD_TO_BUILD, scene=scene.name)
    placed = [(actor.x, actor.y) for actor in (*scene.agents, *scene.objects)]
    places = np.array(placed, dtype=float).reshape(-1, 2)
    points = np.vstack([*(lines[name].points for name in built), places])
    frame, extent, grown = _ground(points, earlier)
    parts = network_tiles(scene, frame) if road == "tiles" else _meshes(scene, lines, built, frame)
    followed = followed_lines(scene, lines)
    paths = {name: i + 1 for i, name in enumerate(followed)}
    for name, number in paths.items():
        parts += path_parts(followed[name], number, frame)
    undriven = undriven_agents(scene, python_driven)
    silent = {*python_driven, *undriven}
    agents = _numbers(scene, {} if earlier is None else earlier.agents)
    driven = [replace(one, drive=()) if one.name in silent else one for one in scene.agents]
    specs = {one.name: agent_spec(one, scene, paths, followed, frame) for one in driven}
    specs = _kept_starts(scene, specs, earlier, restarted, poses or {})
    specs = {one.name: specs[one.name] | look_of(one, agents[one.name]) for one in scene.agents}
    parts += [agent_part(agents[name], spec) for name, spec in specs.items()]
    objects, names = object_parts(map(_placed, scene.objects), frame)
    parts += [*objects, world_part(scene.world, extent + BESIDE if grown else None)]
    parts += camera_parts(scene, parts, agents, names, cameras_of(scene))
    return Layout(
        scene.name, tuple(parts), frame, extent, agents, paths, names, specs, grown, undriven
    )


def _ground(points: NDArray[np.float64], earlier: Layout | None) -> tuple[SceneOrigin, float, bool]:
    """The frame, how far the ground reaches, and whether that is farther than at first."""
    if earlier is None:
        return *frame_around(points), False
    extent = extent_from(earlier.frame, points)
    if extent <= earlier.extent:
        return earlier.frame, earlier.extent, earlier.grown
    return earlier.frame, GROWTH * math.ceil(extent / GROWTH), True


def _kept_starts(
    scene: Scene,
    specs: Mapping[str, dict[str, Any]],
    earlier: Layout | None,
    restarted: Collection[str],
    poses: Mapping[str, AgentPose],
) -> dict[str, dict[str, Any]]:
    """The specifications with the starts of those that were there before an edit."""
    out = dict(specs)
    if earlier is None:
        return out
    for actor in scene.agents:
        if actor.name in earlier.specs:
            anew = actor.name in restarted or actor.group in restarted
            pose, start = poses.get(actor.name), {}
            if pose is not None:
                x, y = pose.x - earlier.frame.x, pose.y - earlier.frame.y
                start = {**asdict(pose), "x": x, "y": y}
            known = earlier.specs[actor.name]
            out[actor.name] = kept_start(specs[actor.name], known, anew, start)
    return out


def _numbers(scene: Scene, known: Mapping[str, int]) -> dict[str, int]:
    """A number for each agent, which it keeps through edits of the scene."""
    names = [actor.name for actor in scene.agents]
    free = iter(sorted(set(range(1, len(names) + len(known) + 1)) - set(known.values())))
    return {name: known[name] if name in known else next(free) for name in names}


def built_roads(scene: Scene, lines: Mapping[str, RoadSamples]) -> list[str]:
    """Names of the roads that are built: the last of each chain, and those that are driven on.

    A road that only repeats edges of a network that is built (a route through a town) is a path
    on them, not a second road.
    """
    driven = {actor.road for actor in scene.agents} & lines.keys()
    wanted = [road.name for road in scene.roads if road.derived or road.name in driven]
    wanted = wanted or [road.name for road in scene.roads]
    networks = [n for n in scene.networks if any(name in wanted for name in n.roads)]
    edges_of = {road.name: road.network for road in scene.roads}
    out = []
    for name in wanted:
        if edges_of[name] is not None:
            out.append(name)
            continue
        covering = [n for n in networks if _covers(n, lines[name], lines)]
        out += [edge for n in covering for edge in n.roads] or [name]
    return list(dict.fromkeys(out))


def _covers(network: SceneNetwork, line: RoadSamples, lines: Mapping[str, RoadSamples]) -> bool:
    from scipy.spatial import cKDTree

    edges = [lines[name] for name in network.roads if name in lines]
    dense = [edge.at(np.linspace(edge.s[0], edge.s[-1], int(edge.length / 0.25) + 2))[0]
             for edge in edges]  # fmt: skip
    samples = line.at(np.linspace(line.s[0], line.s[-1], 200))[0]
    away, _ = cKDTree(np.vstack(dense)).query(samples)
    widest = max(float(edge.width.max()) for edge in edges)
    return bool(np.mean(away < 0.5 * widest) > MOSTLY)


def _meshes(
    scene: Scene, lines: Mapping[str, RoadSamples], built: Iterable[str], frame: SceneOrigin
) -> list[ScenePart]:
    built = list(built)
    roads = {road.name: road for road in scene.roads}
    trims = {
        name: [
            float(lines[name].s[0]) + roads[name].trim[0],
            float(lines[name].s[-1]) - roads[name].trim[1],
        ]
        for name in built
    }
    parts: list[ScenePart] = []
    places: list[SceneJunction] = []
    for network in scene.networks:
        if network.junctions:
            junctions = _junctions_between(network, trims)
            parts += _areas(network, junctions, len(parts) + 1, frame, roads)
            places += junctions
            continue
        for node in network.nodes:  # of a scene of an earlier version
            arms = order(_arms(np.array([node.x, node.y]), node.roads, trims, lines))
            if len(arms) < 2:
                continue
            back = cuts(arms)
            for arm, cut in zip(arms, back, strict=True):
                trims[arm.line.name][0 if arm.sign > 0 else 1] = arm.station(cut)
            label = f"junction {node.id} of {network.name}"
            parts.append(patch(arms, back, len(parts) + 1, frame, label))
    first = 1
    frames = _levels(scene, built, frame)
    for name in built:
        start, end = trims[name]
        if end - start > 0.05:
            pieces = road_parts(lines[name], first, frames[name], start, end)
            parts += pieces
            first += len(pieces)
    parts += sidewalk_parts(scene, places, first, frame)
    return [*parts, *paint_parts(scene, places, frame), *signal_parts(places, frame)]


def _levels(scene: Scene, built: Iterable[str], frame: SceneOrigin) -> Mapping[str, SceneOrigin]:
    """The frames of roads: those of no network lie over each other by a few millimeters, so that
    where two cross, one is seen, and not the lines of both."""
    joined = {name for network in scene.networks for name in network.roads}
    apart = [name for name in built if name not in joined]
    levels = {name: LEVEL * (i % MOST_LEVELS) for i, name in enumerate(apart)}
    return {name: replace(frame, level=levels.get(name, 0.0)) for name in built}


def _junctions_between(network: SceneNetwork, built: Mapping[str, Any]) -> list[SceneJunction]:
    """The junctions all of whose roads are built."""
    return [
        junction
        for junction in network.junctions
        if all(arm.road in built for arm in junction.arms)
    ]


def _areas(
    network: SceneNetwork,
    places: Iterable[SceneJunction],
    first: int,
    frame: SceneOrigin,
    roads: Mapping[str, SceneRoad],
) -> list[ScenePart]:
    parts = []
    for id, place in enumerate(places, start=first):
        label = f"junction {place.id} of {network.name}"
        surface = surface_number(junction_surface(place, roads))
        parts.append(area_patch(place.area, id, frame, label, surface))
    return parts


def _arms(
    node: np.ndarray[Any, Any],
    roads: Iterable[str],
    built: Mapping[str, Any],
    lines: Mapping[str, RoadSamples],
) -> list[RoadArm]:
    out = []
    for name in dict.fromkeys(roads):
        if name not in built or lines[name].closed:
            continue
        line = lines[name]
        start = float(np.hypot(*(line.points[0] - node)))
        end = float(np.hypot(*(line.points[-1] - node)))
        if start < 1.0 and end < 1.0:
            out += [RoadArm(line, 1), RoadArm(line, -1)]
        else:
            out.append(RoadArm(line, 1 if start <= end else -1))
    return out


def _placed(actor: SceneActor) -> Placed:
    return Placed(
        sort=plain_name(actor.kind),
        x=actor.x,
        y=actor.y,
        heading=actor.heading,
        length=actor.length,
        width=actor.width,
        height=actor.height,
        color=object_color(actor),
        name=actor.name,
        alone=actor.name == actor.group,
    )
