"""Wheels on patches of other surfaces: of many agents at once, found as if looked up one by one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry import CrossSection
from roadlang.ir.scene import Scene
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lanes.surfaces import road_surface
from roadlang.simulation.state.world import World
from roadlang.simulation.vehicles.bodies import Bodies
from roadlang.simulation.vehicles.patches import TIRE, WHEELS
from roadlang.simulation.vehicles.vehicle_dynamics import GRAVITY

LOOP = """road loop {
  draw with segments { pieces: [straight(60m), arc(20m, 180deg), straight(60m), arc(20m, 180deg)] }
  closed: true, lanes: 4, surface: gravel
  surface_patches: [{ surface: ice, over: [150m, 170m] }, { surface: turf, over: [0m, 4m] }]
}
agent cars is car on loop at random { count: 6, lane: choice(-1, -2, 1, 2), start_speed: 12m/s }
"""
JOINED = """road one { draw with segments { pieces: [straight(60m)] }, lanes: 2, oneway: true
  surface_patches: [{ surface: ice, over: [20m, 40m], lane: -2 }] }
road two { draw with segments { pieces: [arc(90m, 40deg)] }, lanes: 3, oneway: true }
road main from one { then: [two], taper: 30m }
agent cars is car on main at random { count: 6, lane: choice(-1, -2), start_speed: 15m/s }
"""
SIDES = """road main { draw with segments { pieces: [straight(200m)] }, lanes: 2
  surface_patches: [{ surface: snow, side: right }, { surface: ice, over: [60m, 90m], lane: 1 }] }
agent cars is car on main at random { count: 6, lane: none, offset: -3m..3m, start_speed: 12m/s }
"""


def scenes(text: str, count: int = 3) -> list[Scene]:
    return [scene.record for scene in testing.sample(text, count, seed=5)]


def below(world: World) -> Bodies:
    """Those with the ground that they are on."""
    patches, on = world.verges.patches, (world.motion, world.table, world.present)
    return patches.below(world.bodies, world.bodies, *on, world.verges.has_route)


def looked_up(scene: Scene, world: World, agent: int) -> tuple[float, float]:
    """Mean friction and rolling resistance below the wheels of an agent without a route."""
    motion, bodies = world.motion, world.bodies
    place = world.table.place(np.array([agent]), motion.along[[agent]])
    road = scene.roads[int(place.road[0])]
    section = road.cross_section()
    half_base = bodies.half_base[agent]
    half_track = 0.5 * (bodies.width[agent] - TIRE)
    cosine, sine = motion.cosine[agent], motion.sine[agent]
    found = []
    for i, j in WHEELS:
        ahead = i * half_base * cosine - j * half_track * sine
        left = motion.offset[agent] + i * half_base * sine + j * half_track * cosine
        direction = int(place.direction[0])
        station, offset = place.station[0] + direction * ahead, direction * left
        station = station % road.length if road.closed else np.clip(station, 0.0, road.length)
        name = road.surface
        for lane in section.ids:
            high, low = section.borders(lane, station)
            for patch in road.surface_patches if low <= offset <= high else ():
                there = patch.start <= station <= patch.end
                name = patch.surface if there and lane in (patch.lanes or (lane,)) else name
        surface = road_surface(scene.world, name)
        found.append((surface.friction, surface.rolling))
    friction, rolling = np.mean(found, axis=0)
    return float(friction), float(rolling)


@pytest.mark.parametrize("text", [LOOP, JOINED, SIDES], ids=["loop", "joined", "sides"])
def test_each_wheel_has_the_surface_below_it(text: str) -> None:
    drawn = scenes(text)
    world = world_of(drawn, {}, 0.02, 1.0)
    slots, seen = len(world.present) // len(drawn), set()
    for _ in range(150):
        bodies = below(world)
        for agent in np.flatnonzero(world.present).tolist():
            friction, rolling = looked_up(drawn[agent // slots], world, agent)
            more = rolling - world.verges.patches.rolling[agent]
            assert bodies.friction[agent] == pytest.approx(friction, abs=1e-12)
            slowed = bodies.rolling[agent] - world.bodies.rolling[agent]
            assert slowed == pytest.approx(GRAVITY * more, abs=1e-9)
            seen.add(round(friction, 3))
        zero = np.zeros(len(world.present))
        world.step(zero, zero, None, 2)
    assert len(seen) >= 3


def test_borders_that_are_the_same_all_along_a_road_are_worked_out_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """However many agents there are on it and however long they drive."""
    drawn = scenes(SIDES)
    world = world_of(drawn, {}, 0.02, 1.0)
    zero, asked = np.zeros(len(world.present)), []
    border_offsets = CrossSection.border_offsets

    def counted(section: CrossSection, s: Any) -> Any:
        asked.append(section)
        return border_offsets(section, s)

    world.step(zero, zero, None, 2)
    monkeypatch.setattr(CrossSection, "border_offsets", counted)
    for _ in range(20):
        world.step(zero, zero, None, 2)
    assert not asked
