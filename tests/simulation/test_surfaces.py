"""What is below the wheels of a car decides its grip and how much it is slowed down."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene import SceneRoad
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lanes.lane_columns import LaneSection
from roadlang.simulation.lanes.surfaces import SURFACES, TireSurface
from roadlang.simulation.state.world import World
from roadlang.simulation.vehicles.vehicle_dynamics import GRAVITY

ASPHALT, GRASS, SNOW = (SURFACES[name] for name in ("asphalt", "turf", "snow"))
HALF = TireSurface((ASPHALT.friction + GRASS.friction) / 2, GRASS.rolling / 2)
ROAD = """road main { draw with segments { pieces: [straight(400m)] }, %s }
agent ego is car on main at 5m { lane: none, offset: %sm, start_speed: 20m/s }
"""
ONE_LANE = "width: 8m, lanes: 1"
PATCHED = "width: 8m, lanes: 2, surface_patches: [{ surface: snow, %s }]"
HALF_SNOW = TireSurface((ASPHALT.friction + SNOW.friction) / 2, SNOW.rolling / 2)
SHOULDERS = "left: [drive(width: 4m)], right: [drive(width: 4m), shoulder(width: 3m)]"
ROLLING, DRAG = 0.012, 0.5 * 1.2 * 0.67 / 1500.0


def worlds(*texts: str) -> World:
    """Scenes side by side."""
    scenes = [testing.sample(text, 1)[0].record for text in texts]
    return world_of(scenes, {}, 0.01, 1.0)


def slowed(world: World, acceleration: float) -> np.ndarray:
    """(N,) deceleration over a tenth of a second in which nobody steers."""
    before, zero = world.motion.speed.copy(), np.zeros(len(world.present))
    for _ in range(5):
        world.step(zero, np.full(len(zero), acceleration), None, 2)
    return (before - world.motion.speed) / 0.1


@pytest.mark.parametrize(
    ("road", "offset", "world", "surface"),
    [
        (ONE_LANE, 0.0, "", ASPHALT),
        (ONE_LANE, 3.0, "", ASPHALT),
        (ONE_LANE, 4.0, "", HALF),
        (ONE_LANE, 7.0, "", GRASS),
        (ONE_LANE, -7.0, "", GRASS),
        ("width: 8m, surface: ice", 0.0, "", SURFACES["ice"]),
        ("width: 8m, surface: gravel", 0.0, "world { weather: rain }", SURFACES["gravel"]),
        (PATCHED % "side: right", -2.0, "", SNOW),
        (PATCHED % "lane: 1", -2.0, "", ASPHALT),
        (PATCHED % "side: left", 0.0, "", HALF_SNOW),
        (PATCHED % "over: [300m, 350m]", 0.0, "", ASPHALT),
        (SHOULDERS, -5.0, "", ASPHALT),
        (SHOULDERS, -8.5, "", GRASS),
        (ONE_LANE, 0.0, "world { weather: rain }", SURFACES["wet"]),
        (ONE_LANE, 0.0, "world { rain: 5mm/h }", SURFACES["wet"]),
        (ONE_LANE, 0.0, "world { weather: snow }", SNOW),
        (ONE_LANE, 7.0, "world { weather: snow }", TireSurface(SNOW.friction, GRASS.rolling)),
        (ONE_LANE, 0.0, "world { weather: snow, friction: 0.5 }", TireSurface(0.5, SNOW.rolling)),
        (ONE_LANE, 7.0, "world { friction: 0.2 }", TireSurface(0.2, GRASS.rolling)),
    ],
)
def test_cars_have_the_grip_and_the_resistance_of_what_is_below_their_wheels(
    road: str, offset: float, world: str, surface: TireSurface
) -> None:
    text = ROAD % (road, offset) + world
    for acceleration, friction in ((-12.0, surface.friction), (0.0, 0.0)):
        lost = slowed(worlds(text), acceleration)[0]
        expected = (friction + ROLLING + surface.rolling) * GRAVITY + DRAG * 19.7**2
        assert lost == pytest.approx(expected, rel=0.01, abs=0.01)


def test_roads_of_hardly_any_friction_are_driven() -> None:
    world = worlds(*(ROAD % (ONE_LANE, offset) + "world { friction: 1e-300 }" for offset in (0, 7)))
    slowed(world, -12.0)
    assert np.isfinite(world.motion.speed).all()
    assert world.verges.friction.tolist() == world.bodies.friction.tolist() == [1e-3, 1e-3]


def test_scenes_side_by_side_have_their_own_ground() -> None:
    texts = [ROAD % (ONE_LANE, offset) for offset in (0.0, 4.0, 7.0)]
    together = slowed(worlds(*texts), -12.0)
    alone = [slowed(worlds(text), -12.0)[0] for text in texts]
    assert together.tolist() == alone


def test_edges_of_roads_with_the_same_lanes_are_worked_out_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As of all scenes that bend one road."""
    looked_at: list[SceneRoad] = []
    of = LaneSection.of

    def counted(road: SceneRoad) -> LaneSection:
        looked_at.append(road)
        return of(road)

    wide = ROAD % ("width: 14m, lanes: 1", 6.5)
    world = worlds(*[ROAD % (ONE_LANE, offset) for offset in (4.0, 7.0, -4.0)], wide)
    monkeypatch.setattr(LaneSection, "of", counted)
    rolling = np.array([HALF.rolling, GRASS.rolling, HALF.rolling, HALF.rolling])
    expected = (ROLLING + rolling) * GRAVITY + DRAG * 19.7**2
    np.testing.assert_allclose(slowed(world, 0.0), expected, rtol=0.01, atol=0.01)
    assert len(looked_at) == 2
