"""The world of some scenes at the start."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ...ir.scene import Scene, SceneActor, SceneRoad
from ..bends.kept_in_lane import kept_in_lane
from ..bends.leaning import leaned
from ..bends.sweeps import Sweeps
from ..junctions.stop_lines import StopLines, has_signals
from ..lanes.surfaces import TireSurface, road_surface
from ..lines.followed_lines import FollowedLines
from ..lines.lane_guides import LaneGuides
from ..lines.line_sources import LineSource, road_line, straight_line, without_jumps
from ..lines.lines import Lines
from ..lines.route_lines import RouteLine, plain_line, route_line
from ..lines.route_table import RouteTable
from ..state.arrivals import Arrivals
from ..state.line_heights import LineHeights
from ..state.world import World
from ..surroundings.crossed_junctions import crossings_of
from ..surroundings.outlines import Outlines
from ..vehicles import compiled
from ..vehicles.bodies import Bodies, Body
from ..vehicles.motion import Track
from ..vehicles.verges import Verges
from .keeping_clear import kept_clear
from .starting import LineOffsets, start_of, start_speed

FASTEST = 120.0
"""m/s: lines go on beyond their ends for as far as this takes an agent in one step."""


def world_of(scenes: Sequence[Scene], kinds: Mapping[str, Body], dt: float, margin: float) -> World:
    """The world of some scenes at the start. `margin`: seconds of the longest step."""
    slots = max(1, *(len(scene.agents) for scene in scenes))
    sources: list[LineSource] = []
    routes: list[RouteLine] = []
    found: list[_Slot] = []
    lines_of: dict[int, dict[Any, int]] = {}  # by the identity of scenes, of which some are equal
    for scene in scenes:
        names = {road.name: number for number, road in enumerate(scene.roads)}
        rows = lines_of.setdefault(id(scene), {})
        for place in range(slots):
            actor = scene.agents[place] if place < len(scene.agents) else None
            found.append(_slot(actor, scene, names, rows, (sources, routes)))
    pays = compiled.pays_for_lines(len(sources))
    loops = (compiled.line_nodes, compiled.line_table, compiled.LINES_AT_ONCE) if pays else ()
    lines = Lines.of(without_jumps(sources), FASTEST * margin, *loops)  # the same to the last bit
    table = RouteTable.of(routes, np.array([slot.route for slot in found], dtype=np.int64))
    over = {slot.line: (i // slots, routes[slot.route]) for i, slot in enumerate(found)}
    heights = LineHeights.of(scenes, lines, [over[row] for row in range(len(sources))])
    return _started(tuple(scenes), slots, found, lines, (table, heights), kinds, dt)


@dataclass(frozen=True)
class _Slot:
    actor: SceneActor | None
    line: int
    route: int
    road: int
    surface: TireSurface


_NOBODY = SceneActor("", "", "", 0.0, 0.0, 0.0, 1.0, 1.0, 1.0)


def _slot(
    actor: SceneActor | None,
    scene: Scene,
    roads: Mapping[str, int],
    rows: dict[Any, int],
    built: tuple[list[LineSource], list[RouteLine]],
) -> _Slot:
    """An agent with its line, which those of one road and direction share."""
    sources, routes = built
    placed = actor or _NOBODY
    number = roads.get(placed.road or "", -1)
    backward = placed.facing == "back"
    key: Any = (number, backward) if number >= 0 else (placed.x, placed.y, placed.heading)
    key = key if placed.route is None else id(placed.route)
    if placed.route is not None and key not in rows:
        rows[key] = len(sources)
        rows[key, 0] = len(routes)
        line = kept_in_lane(route_line(placed.route, scene, roads), placed)
        line = leaned(line, placed)
        routes.append(kept_clear(line, placed, Outlines.of(scene.objects)))
        sources.append(routes[-1].source)
    elif key not in rows:
        rows[key] = len(sources)
        on_road = number >= 0
        sources.append(
            road_line(scene.roads[number], backward)
            if on_road
            else straight_line(placed.x, placed.y, placed.heading)
        )
    lane = 0 if placed.route is not None else placed.lane or 0
    if (key, lane) not in rows:
        rows[key, lane] = len(routes)
        road = scene.roads[number] if number >= 0 else None
        routes.append(plain_line(sources[rows[key]], number, road, lane, backward))
    said = scene.roads[number].surface if number >= 0 else None
    return _Slot(actor, rows[key], rows[key, lane], number, road_surface(scene.world, said))


def _crowded(scenes: tuple[Scene, ...]) -> Booleans:
    """(S,) where an agent may meet another, or an object."""
    return np.array([len(scene.agents) + len(scene.objects) > 1 for scene in scenes], dtype=bool)


def _line_offsets(
    scenes: tuple[Scene, ...], slots: int, agents: Iterable[tuple[SceneActor, int, float, int]]
) -> list[float]:
    """Of the lines that agents follow. `agents`: each with its road, the width of its line and its
    guide."""
    known = LineOffsets()
    return [
        known.of(actor, scenes[i // slots].roads[road] if road >= 0 else None, width, guide)
        for i, (actor, road, width, guide) in enumerate(agents)
    ]


def _guides(
    scenes: tuple[Scene, ...], slots: int, found: Sequence[_Slot], count: int
) -> tuple[LaneGuides, list[int]]:
    """Of `count` lines, and which of them agents begin with, -1 for none."""
    roads: list[tuple[SceneRoad, bool] | None] = [None] * count
    for place, slot in enumerate(found):
        actor = slot.actor or _NOBODY
        if slot.road >= 0 and actor.route is None:
            road = scenes[place // slots].roads[slot.road]
            roads[slot.line] = road, actor.facing == "back"
    guides = LaneGuides.of(roads)
    return guides, [guides.number(slot.line, (slot.actor or _NOBODY).lane or 0) for slot in found]


def _followed(
    scenes: tuple[Scene, ...], slots: int, found: Sequence[_Slot], track: Track,
    start: tuple[Booleans, Floats],
) -> FollowedLines:  # fmt: skip
    """The lines that agents follow. `start`: who goes against its road, and from which arc lengths
    agents begin."""
    backward, along = start
    widths = track.lines.width[track.cell(along)[0]].tolist()
    guides, numbers = _guides(scenes, slots, found, len(track.lines.length))
    actors = [slot.actor or _NOBODY for slot in found]
    on_lines = zip(actors, [slot.road for slot in found], widths, numbers, strict=True)
    offsets = np.where(backward, -1.0, 1.0) * np.array(_line_offsets(scenes, slots, on_lines))
    guide = np.array(numbers, dtype=np.int64)
    speed = np.array([start_speed(actor) for actor in actors])
    return FollowedLines.at_rest(offsets, guides, track.row, guide, (along, speed))


def _started(
    scenes: tuple[Scene, ...],
    slots: int,
    found: Sequence[_Slot],
    lines: Lines,
    led: tuple[RouteTable, LineHeights | None],
    kinds: Mapping[str, Body],
    dt: float,
) -> World:
    """`led`: what the lines lead over, and how high."""
    actors = [slot.actor or _NOBODY for slot in found]
    present = np.array([slot.actor is not None for slot in found], dtype=bool)
    row = np.array([slot.line for slot in found], dtype=np.int64)
    road = np.array([slot.road for slot in found], dtype=np.int64)
    track = Track.of(lines, row)
    has_route = np.array([actor.route is not None for actor in actors], dtype=bool)
    backward = np.array([actor.facing == "back" for actor in actors], dtype=bool) & ~has_route
    has_road = road >= 0
    start = start_of(actors, track, backward, has_road)
    surfaces = [slot.surface for slot in found]
    bodies = Bodies.of(actors, surfaces, kinds, dt)
    narrowest = lines.column(lines.width).min(axis=1)[row]
    verges = Verges.of(scenes, road, has_route, narrowest, bodies, surfaces)
    count = len(found)
    arrivals = [Arrivals(scene) for scene in scenes]
    lengths = track.length.tolist()
    ends = [arrivals[i // slots].end(actor, lengths[i]) for i, actor in enumerate(actors)]
    followed = _followed(scenes, slots, found, track, (backward, start.along))
    world = World(
        scenes, slots, dt, present, present.copy(), tuple(slot.actor for slot in found),
        np.array([actor.name for actor in actors], dtype=object), bodies, verges, track, led[0],
        Sweeps.of(bodies, lines, row, present & np.repeat(_crowded(scenes), slots)),
        has_road, has_route, backward, road, followed, np.array(ends), start, start, ~present,
        np.zeros(count), np.zeros(count), np.zeros(count), np.zeros(count),
        (np.zeros(count), np.zeros(count)), np.zeros(count, dtype=np.int64),
        StopLines.none(count), led[1],
    )  # fmt: skip
    if any(map(has_signals, scenes)):
        world.stop_lines = StopLines.of(crossings_of(world))
    world.reset()
    return world
