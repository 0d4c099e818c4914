"""Long vehicles in bends: where they drive, what they cover, and who waits for whom."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene import SceneActor
from roadlang.simulation.bends.leaning import leaned
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.route_lines import LineLeg, RouteLine
from roadlang.simulation.traffic.sampled_ways import SampledWays
from roadlang.simulation.traffic.wide_places import WidePlaces

from .crossing_traffic import contacts
from .driven_roads import drive

RADIUS = 20.0


def circle(count: int = 400) -> RouteLine:
    """A circle to the left, driven once around."""
    angle = np.linspace(0.0, 2.0 * math.pi, count)
    s, x, y = RADIUS * angle, RADIUS * np.sin(angle), RADIUS * (1.0 - np.cos(angle))
    source = LineSource(s, x, y, angle, 3.5, closed=True)
    half = float(s[-1]) / 2.0
    legs = (
        LineLeg(0, 0, -1, 0.0, np.array([0.0, half]), np.array([0.0, half]), math.inf),
        LineLeg(1, 1, -1, half, np.array([half, 2.0 * half]), np.array([0.0, half]), math.inf),
    )
    return RouteLine(source, legs)


def vehicle(length: float) -> SceneActor:
    return SceneActor("one", "bus", "", 0.0, 0.0, 0.0, length, 2.55, 3.0)


@pytest.mark.parametrize("length", [9.0, 12.0])
def test_a_long_vehicle_covers_as_much_ground_outside_of_its_lane_as_inside(length: float) -> None:
    source = leaned(circle(), vehicle(length)).source
    base, front = 0.3 * length, 0.8 * length  # the wheelbase is 0.6 of the length
    middle = np.hypot(source.x, source.y - RADIUS)
    assert np.ptp(middle) < 0.01
    rear_axle = math.sqrt(middle[0] ** 2 - base**2)
    outside = math.hypot(rear_axle, front) - RADIUS
    inside = RADIUS - rear_axle
    assert outside == pytest.approx(inside, rel=0.2)
    assert outside < 0.7 * (math.hypot(math.sqrt(RADIUS**2 - base**2), front) - RADIUS)


@pytest.mark.parametrize("length", [0.3, 1.2, 3.0])
def test_lines_shorter_than_a_vehicle_are_followed_as_well(length: float) -> None:
    s = np.linspace(0.0, length, 5)
    source = LineSource(s, s.copy(), np.zeros(5), np.linspace(0.0, 1.0, 5), 3.5, closed=False)
    leg = LineLeg(0, 0, -1, 0.0, np.array([0.0, length]), np.array([0.0, length]), math.inf)
    moved = leaned(RouteLine(source, (leg,)), vehicle(12.0)).source
    assert np.isfinite(moved.x).all()
    assert moved.length == pytest.approx(length, rel=0.5)


def test_a_car_keeps_to_the_middle_of_its_lane() -> None:
    line = circle()
    assert leaned(line, vehicle(4.5)) is line


def test_what_a_line_leads_over_moves_with_it() -> None:
    line = circle()
    moved = leaned(line, vehicle(12.0))
    assert moved.source.length < line.source.length - 1.0
    assert moved.legs[1].begin == pytest.approx(0.5 * moved.source.length, abs=0.1)
    assert moved.legs[1].along[-1] == pytest.approx(moved.source.length)


CORNER = """
image plan from \"\"\"
..........
.########.
.#......#.
.#......#.
.#......#.
.########.
..........
\"\"\" { scale: 20m/px }
network town from plan { lanes: 2 }
"""


def test_the_ground_that_a_bus_covers_is_that_of_its_corners() -> None:
    text = CORNER + "agent bus is bus on town { route: random, drive with traffic }"
    text += "\nobject cone is cone at (0m, 0m)"  # who meets nobody needs no such ground
    scene = testing.sample(text, 1, seed=2)
    (driven,) = scene.run("builtin", duration=11.0, control_step=0.1)
    world = world_of([scene[0].record], {}, 0.02, 0.1)
    trace = driven.trace.agents["bus"]
    lines, row = world.track.lines, int(world.track.row[0])
    nodes = slice(row * lines.cells, row * lines.cells + 180)  # before it comes around again
    heading = lines.heading[nodes]
    swept = [side[world.sweeps.table[0]] for side in (world.sweeps.left, world.sweeps.right)]
    assert max(side.max() for side in swept) > 0.5
    for ahead in (6.0, -6.0):
        for side, left in ((0, 1.275), (1, -1.275)):
            x = trace.x + np.cos(trace.heading) * ahead - np.sin(trace.heading) * left
            y = trace.y + np.sin(trace.heading) * ahead + np.cos(trace.heading) * left
            off_x, off_y = x[:, None] - lines.x[nodes], y[:, None] - lines.y[nodes]
            foot = (off_x * off_x + off_y * off_y).argmin(axis=1)
            each = np.arange(len(foot))
            across = np.cos(heading[foot]) * off_y[each, foot]
            across = across - np.sin(heading[foot]) * off_x[each, foot]
            beyond = np.abs(across) - 1.275 - swept[side][foot]
            inner = (foot > 2) & (foot < 170)
            assert beyond[inner].max() < 0.45


def test_no_wide_place_ahead_is_overlooked() -> None:
    text = CORNER + "agent buses is bus on town at random { count: 4, drive with traffic }"
    world = world_of([testing.sample(text, 1, seed=2)[0].record], {}, 0.02, 0.04)
    found, agents = WidePlaces.of(world), np.arange(len(world.present))
    told = []
    for step in range(200):
        world.motion.along = np.minimum(world.motion.along + 0.37 * (step > 0), world.end)
        samples = SampledWays.of(world, agents)
        is_there, may_be = samples.is_wide.any(axis=0), found.may_be_ahead(world)
        assert not (is_there & ~may_be).any()
        told.append((is_there.sum(), (~may_be).sum()))
    assert all(np.sum(told, axis=0) > 20), "some are wide, and of some that is ruled out"


def buses(seed: int) -> Any:
    text = (
        CORNER
        + """
    agent buses is bus on town at random { count: 4, drive with traffic }
    """
    )
    (driven,) = testing.sample(text, 1, seed=seed).run("builtin", duration=60.0, control_step=0.1)
    return driven.trace


@pytest.mark.parametrize("seed", [2, 4])
def test_buses_that_meet_in_narrow_bends_wait_for_each_other(seed: int) -> None:
    trace = buses(seed)
    assert contacts(trace) == []
    for bus in trace.agents.values():
        standing = (bus.speed < 0.1) & (bus.present > 0.0) & (bus.time > 1.0)
        longest = max((len(run) for run in _runs(standing)), default=0)
        assert longest * (bus.time[1] - bus.time[0]) < 30.0


def _runs(flags: Any) -> list[Any]:
    edges = np.flatnonzero(np.diff(np.r_[False, flags, False]))
    return [range(a, b) for a, b in zip(edges[::2], edges[1::2], strict=True)]


TURN = """
image plan from \"\"\"
......#......
......#......
......#......
......#......
#############
\"\"\" { scale: 8m/px }
network town from plan { lanes: 2, control with yield }
"""


@pytest.mark.parametrize("length", [9.0, 12.0])
def test_a_long_vehicle_does_not_swing_out_as_it_leaves_a_turn(length: float) -> None:
    text = (
        TURN
        + f"""
    agent long is truck on town {{
      route: [(10m, 2m), (52m, 30m)], length: {length}m, start_speed: 30km/h
      drive with traffic {{ aggression: 1 }}
    }}
    """
    )
    (driven,) = testing.sample(text, 1, seed=1).run("builtin", duration=12.0, control_step=0.1)
    trace = driven.trace.agents["long"]
    moving = trace.present > 0.0
    assert np.abs(trace.cross_track_error[moving]).max() < 0.45


def test_who_stands_before_somebody_in_a_bend_lets_that_one_pass() -> None:
    """The coach cannot pass the car as both begin, but the car can pass the coach."""
    text = '''
    image plan from """
    ########...
    .......#...
    .......#...
    .......#...
    .......#...
    """ { scale: 10.5m/px, legend: { "#": road } }
    network town from plan { lanes: 3, speed_limit: 50km/h }
    agent coach is bus on town at (67m, 45.5m) {
      route: [(84m, 5m)], start_speed: 0, drive with traffic
    }
    agent car is car on town at (75m, 49.5m) {
      route: [(5m, 49m)], start_speed: 0, drive with traffic
    }
    '''
    (trace,) = drive(text, duration=25.0)
    assert trace.events == ()
    assert all(agent.route_progress[-1] > 30.0 for agent in trace.agents.values())
