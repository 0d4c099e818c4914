"""A scene as nodes: ground, roads with their lanes, junctions, objects and agents."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from roadlang.api import signal_heads
from roadlang.geometry import Floats

from ..surfaces.heights import GROUND_BELOW, SceneHeights
from ..surfaces.junction_surface import JunctionSurface, junction_surfaces
from ..surfaces.prisms import junction_prisms, road_prisms
from ..surfaces.road_surface import RoadSurface, road_surfaces
from .convex_meshes import put_box, put_prisms
from .glb import GlbWriter
from .junction_meshes import area_part, crosswalk_parts, edge_parts, paint_parts, signal_parts
from .materials import MATERIALS, Material, painted
from .meshes import Faces, joined, moved
from .road_meshes import curb_parts, embankment_parts, lane_parts, marking_parts
from .shapes import body

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor

Collision = Literal["godot", "unreal", "none"]

_TOLERANCE = 0.005
"""Meters by which edges of roads may be off."""
_BESIDE = 150.0
"""Ground around everything, meters."""


@dataclass
class SceneNodes:
    """Writes the nodes of one scene. `agents` are the numbers of theirs by name."""

    scene: Scene
    writer: GlbWriter
    collision: Collision
    agents: dict[str, int] = field(default_factory=dict)
    _meshes: dict[tuple[Any, ...], int] = field(default_factory=dict)

    def write(self) -> None:
        """All of it."""
        roads = list(road_surfaces(self.scene, _TOLERANCE))
        junctions = list(junction_surfaces(self.scene))
        edges = [surface.borders.reshape(-1, 3) for surface in roads]
        points = np.concatenate([*edges, *(place.ring for place in junctions)])
        ground = float(points[:, 2].min()) - GROUND_BELOW
        heights = SceneHeights.of(self.scene)
        names = [
            self._ground(points, ground),
            self._group("roads", [self._road(surface, ground) for surface in roads]),
            self._group("junctions", [self._junction(place, ground) for place in junctions]),
            self._group("crosswalks", self._crosswalks(heights)),
            self._group("objects", [self._actor(thing, heights) for thing in self.scene.objects]),
            self._group("agents", self._moving(heights)),
        ]
        if self.collision == "unreal":
            names.append(self._group("collision", self._boxes(heights)))
        title = self.scene.name
        children = [name for name in names if name is not None]
        self.writer.root(self.writer.node(title, children=children))

    def _crosswalks(self, heights: SceneHeights) -> list[int]:
        parts = list(crosswalk_parts(self.scene, heights))
        if not parts:
            return []
        first = self.scene.markings[0]
        at = np.array([first.x, first.y, heights.at_actor(first)])
        return self._extra("crosswalks", "markings", joined(parts), at, False)

    def _moving(self, heights: SceneHeights) -> list[int]:
        for agent in self.scene.agents:
            self.agents[agent.name] = self._actor(agent, heights)
        return list(self.agents.values())

    def _boxes(self, heights: SceneHeights) -> list[int]:
        """Those of objects and agents."""
        return [
            put_box(
                self.writer,
                actor.name,
                (actor.length, actor.width, actor.height),
                (actor.x, actor.y, heights.at_actor(actor)),
                actor.heading,
            )
            for actor in (*self.scene.objects, *self.scene.agents)
        ]

    def _group(self, name: str, children: list[int]) -> int | None:
        return self.writer.node(name, children=children) if children else None

    def _ground(self, points: Floats, height: float) -> int:
        (west, south), (east, north) = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
        x, y = (west + east) / 2.0, (south + north) / 2.0
        half = np.array([east - west, north - south]) / 2.0 + _BESIDE
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
        part = Faces(
            "ground",
            np.column_stack((corners, np.zeros(4))),
            np.tile([0.0, 0.0, 1.0], (4, 1)),
            np.array([[0, 1, 2], [0, 2, 3]]),
            corners,
        )
        return self._solid("ground", [part], (round(x), round(y), height), {"part": "ground"})

    def _road(self, surface: RoadSurface, ground: float) -> int:
        road = surface.road
        at = _middle(surface.borders)
        children = [
            self._solid(
                f"{road.name} lane {id} {kind}",
                [moved(part, -at)],
                at,
                {"part": "lane", "road": road.name, "lane": id, "kind": kind},
            )
            for id, kind, part in lane_parts(surface)
        ]
        for name, parts, solid in (
            ("curbs", curb_parts(surface), True),
            ("embankment", embankment_parts(surface, ground), True),
            ("markings", marking_parts(surface), False),
        ):
            children += self._extra(road.name, name, joined(parts), at, solid)
        if self.collision == "unreal" and children:
            of = self.writer.name(children[0])
            prisms = (prism for prism, _ in road_prisms(surface))
            children += put_prisms(self.writer, of, prisms, at)
        extras = {"part": "road", "road": road.name, "length": road.length}
        return self.writer.node(f"road {road.name}", children=children, extras=extras)

    def _junction(self, surface: JunctionSurface, ground: float) -> int:
        name, at = surface.name, _middle(surface.ring)
        children = []
        for part_name, parts, solid in (
            ("area", [area_part(surface)], True),
            ("embankment", edge_parts(surface, ground), True),
            ("markings", paint_parts(self.scene, surface), False),
        ):
            children += self._extra(name, part_name, joined(parts), at, solid)
        if self.collision == "unreal" and children:
            prisms = junction_prisms(surface)
            children += put_prisms(self.writer, self.writer.name(children[0]), prisms, at)
        height = float(surface.ring[:, 2].mean())
        for number, head in enumerate(signal_heads(surface.junction)):
            mesh = self._shared(("signal",), "signal", joined(signal_parts()), MATERIALS)
            children.append(
                self.writer.node(
                    f"{name} signal {number}",
                    mesh=mesh,
                    at=(head.x, head.y, height),
                    heading=head.heading,
                    extras={"part": "signal", "connections": list(head.connections)},
                )
            )
        return self.writer.node(name, children=children, extras={"part": "junction", "name": name})

    def _extra(
        self, owner: str, name: str, parts: Iterable[Faces], at: Floats, solid: bool
    ) -> list[int]:
        found = [moved(part, -at) for part in parts]
        if not found:
            return []
        extras = {"part": name, "of": owner}
        if solid:
            return [self._solid(f"{owner} {name}", found, at, extras)]
        mesh = self.writer.mesh(f"{owner} {name}", found, MATERIALS)
        return [self.writer.node(f"{owner} {name}", mesh=mesh, at=at.tolist(), extras=extras)]

    def _solid(
        self, name: str, parts: list[Faces], at: Iterable[float], extras: Mapping[str, Any]
    ) -> int:
        """A node whose triangles are solid too."""
        name = f"{name}-col" if self.collision == "godot" else name
        mesh = self.writer.mesh(name, parts, MATERIALS)
        solid = {"collision": "mesh"} if self.collision == "godot" else {}
        return self.writer.node(name, mesh=mesh, at=tuple(at), extras={**extras, **solid})

    def _actor(self, actor: SceneActor, heights: SceneHeights) -> int:
        color = actor.options.get("color")
        paint = painted(actor.kind, color if isinstance(color, str) else "gray")
        size = actor.length, actor.width, actor.height
        key: tuple[Any, ...] = (actor.kind, paint, *size)
        parts = body(actor.category, paint.name, *size)
        # Unreal Engine finds convex meshes by the name of the mesh, so that none is shared.
        shared = self.collision != "unreal"
        key = key if shared else (actor.name,)
        label = actor.kind if shared else actor.name
        mesh = self._shared(key, label, parts, {**MATERIALS, paint.name: paint})
        solid = {"collision": "convex"} if self.collision == "godot" else {}
        extras = {"name": actor.name, "kind": actor.kind, "size": list(size), **solid}
        name = f"{actor.name}-convcol" if self.collision == "godot" else actor.name
        at = (actor.x, actor.y, heights.at_actor(actor))
        return self.writer.node(name, mesh=mesh, at=at, heading=actor.heading, extras=extras)

    def _shared(
        self,
        key: tuple[Any, ...],
        name: str,
        parts: tuple[Faces, ...],
        materials: Mapping[str, Material],
    ) -> int:
        if key not in self._meshes:
            self._meshes[key] = self.writer.mesh(name, parts, materials)
        return self._meshes[key]


def _middle(points: Floats) -> Floats:
    """A place near the middle, in full meters."""
    flat = points.reshape(-1, 3)
    return np.asarray(np.round((flat.min(axis=0) + flat.max(axis=0)) / 2.0))
