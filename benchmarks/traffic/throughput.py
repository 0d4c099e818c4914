"""Cars that a crossing with signals lets through, beside SUMO on the same demand.

    python -m benchmarks.traffic.throughput [--demand 300 600 900 1200] [--lanes 2] [--turns 0.4]
                                            [--green 18] [--cycles 5] [--seeds 1 2 3]

SUMO is found on the path or in SUMO_HOME (`pip install eclipse-sumo`); without it only our own
numbers are printed. Each is the sum over the seeds. Ends with 1 if one differs from SUMO's by more
than 20 %.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import replace
from random import Random

import numpy as np

from roadlang import testing
from roadlang.drive.controllers import python_controllers
from roadlang.drive.simulators import simulator_of
from roadlang.ir.scene import Scene, SceneActor
from roadlang.ir.scene_junctions import SceneConnection, SceneJunction
from roadlang.ir.scene_route import RouteStep, RouteTurn, SceneRoute
from roadlang.plugins.discovery import load_registry

from .demand import ALL_RED, CAR, YELLOW, Demand
from .sumo import sumo_throughput

CELL = 50
"""Meters of the typed map."""
ALLOWED = 0.2


def main() -> int:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demand", type=int, nargs="+", default=[300, 600, 900, 1200])
    parser.add_argument("--lanes", type=int, nargs="+", default=[2])
    parser.add_argument("--turns", type=float, nargs="+", default=[0.0, 0.4])
    parser.add_argument("--green", type=int, nargs="+", default=[18])
    parser.add_argument("--cycles", type=int, default=5)
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    given = parser.parse_args()
    every = [
        Demand(flow, lanes, turns, green, given.cycles)
        for lanes in given.lanes
        for green in given.green
        for turns in given.turns
        for flow in given.demand
    ]
    print("cars/h/arm  lanes  turning  green  come  ours  SUMO  ours/SUMO  by seed", flush=True)
    outside = 0
    for demand in every:
        seeded = [replace(demand, seed=seed) for seed in given.seeds]
        ours = [our_throughput(one) for one in seeded]
        theirs = [found for one in seeded if (found := sumo_throughput(one)) is not None]
        ratio = sum(ours) / sum(theirs) if theirs else float("nan")
        outside += abs(ratio - 1.0) > ALLOWED
        come = sum(len(cars) for one in seeded for cars in one.arms)
        shown = f"{sum(theirs)}" if theirs else "-"
        each = " ".join(f"{a / b:.2f}" for a, b in zip(ours, theirs, strict=False))
        print(
            f"{demand.flow:10} {demand.lanes:6} {demand.turns:8.0%} {demand.green:5}s {come:5} "
            f"{sum(ours):5} {shown:>5} {ratio:10.2f}  {each}",
            flush=True,
        )
    if not theirs:
        print("SUMO is not installed: nothing to compare with")
    return 1 if outside else 0


def our_throughput(demand: Demand) -> int:
    """Cars whose front crosses a stop line in the time of the demand."""
    registry = load_registry()
    empty = testing.sample(_text(demand), 1)[0].record
    scene = replace(empty, agents=tuple(_agents(empty, demand)))
    _, simulator = simulator_of(scene, registry, "builtin", {"duration": demand.duration})
    (trace,) = simulator.drive_all([scene], [python_controllers(scene, registry)])
    passed = 0
    for agent in scene.agents:
        assert agent.route is not None
        first = agent.route.steps[0]
        driven = trace.agents[agent.name].route_progress + 0.5 * agent.length
        passed += bool(driven[-1] > abs(first.stop - first.start))
    return passed


def _text(demand: Demand) -> str:
    arm = int(demand.longest // CELL) + 2
    rows = ["." * arm + "#" + "." * arm] * arm
    plan = "\n".join([*rows, "#" * (2 * arm + 1), *rows])
    return f"""
image plan from \"\"\"
{plan}
\"\"\" {{ scale: {CELL}m/px, legend: {{ "#": road }} }}
network town from plan {{
  extract with auto {{ width: {3.5 * demand.lanes}m }}
  lanes: {demand.lanes}
  speed_limit: {demand.speed}m/s
  control with signals {{ green: {demand.green}s, yellow: {YELLOW}s, all_red: {ALL_RED}s }}
}}
agent driver is car on town at random {{
  length: {CAR}m
  drive with traffic
}}
"""


def _agents(scene: Scene, demand: Demand) -> Iterator[SceneActor]:
    """The cars of all arms, each in the lane where fewest are from which its turn leads."""
    network, (driver,) = scene.networks[-1], scene.agents
    (junction,) = (one for one in network.junctions if one.connections)
    draw = Random(f"drivers of {demand}")
    for number, road in enumerate(_arms_in_order(junction)):
        last: dict[int, float] = {}
        for place, car in enumerate(demand.arms[number]):
            turn = [c for c in junction.connections if c.source.road == road and c.turn == car.turn]
            chosen = min(turn, key=lambda c: last.get(c.source.lane, 0.0))
            lane = chosen.source.lane
            distance = max(car.distance, last.get(lane, 0.0) + CAR + 2.5)
            last[lane] = distance
            name = f"{number}.{place}"
            yield _placed(scene, (network.name, junction), chosen, replace(driver, name=name),
                          distance, draw)  # fmt: skip


def _arms_in_order(junction: SceneJunction) -> list[str]:
    """The roads, clockwise by where they come from."""
    heading = {one.source.road: one.start[2] for one in junction.connections}
    return sorted(heading, key=lambda road: -(heading[road] % (2.0 * np.pi)))


def _placed(
    scene: Scene, place: tuple[str, SceneJunction], turn: SceneConnection, driver: SceneActor,
    distance: float, draw: Random,
) -> SceneActor:  # fmt: skip
    """A car whose front is so many meters before its stop line."""
    network, junction = place
    roads = {road.name: road for road in scene.roads}
    road, target = roads[turn.source.road], roads[turn.target.road]
    ends = turn.source.end == "end"
    stop = road.length - road.trim[1] if ends else road.trim[0]
    way = 1.0 if ends else -1.0
    start = stop - way * (distance + 0.5 * driver.length)
    far = target.length if turn.target.end == "start" else 0.0
    begin = target.trim[0] if turn.target.end == "start" else target.length - target.trim[1]
    steps = (
        RouteStep(turn.source.road, turn.source.lane, start, stop,
                  RouteTurn(network, junction.id, turn.id)),
        RouteStep(turn.target.road, turn.target.lane, begin, far),
    )  # fmt: skip
    offset = float(road.cross_section().offset(turn.source.lane, start))
    x, y, heading = (
        float(np.interp(start, road.stations, c)) for c in (road.x, road.y, np.unwrap(road.heading))
    )
    (call,) = driver.drive
    options = {**call.options, "speed_factor": draw.uniform(0.9, 1.1)}
    return replace(
        driver, x=x - np.sin(heading) * offset, y=y + np.cos(heading) * offset,
        heading=heading + (0.0 if ends else np.pi), road=road.name, start=start, offset=offset,
        lane=turn.source.lane, facing="forward" if ends else "back", route=SceneRoute(steps),
        drive=(replace(call, options=options),), start_speed=min(12.0, 0.4 * distance),
    )  # fmt: skip


if __name__ == "__main__":
    sys.exit(main())
