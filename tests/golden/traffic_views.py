"""Drives in traffic and of every controller with one option changed, in lines."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from pathlib import Path

from roadlang import testing
from roadlang.api import Trace
from tests.golden.summaries import array
from tests.simulation.mirrored_scenes import Lines, random_pair
from tests.simulation.routed_scenes import CONTROL_STEP, drive_scenes

_COLUMNS = ("speed", "acceleration", "steering", "lane", "contacts", "present")


def traffic_lines(seeds: range, seconds: float) -> Iterator[str]:
    """Random scenes: crossings, forks, roundabouts and bends, under all rules, left and right."""
    scenes = []
    for seed in seeds:
        pair = random_pair(seed)
        with tempfile.TemporaryDirectory() as name:
            pair.write(Path(name))
            text = pair.left if seed % 2 else pair.right
            found = testing.sample(text, 1, kinds=[Lines], folder=Path(name), seed=1)
            scenes.append(found[0].record)
    for seed, trace in zip(seeds, drive_scenes(scenes, duration=seconds), strict=True):
        yield f"{seed}: {'left' if seed % 2 else 'right'}"
        yield from agent_lines(trace)


def agent_lines(trace: Trace) -> Iterator[str]:
    """A line for each agent: how far it got, and its columns together."""
    for name, agent in trace.agents.items():
        places = (agent.x - agent.x[0], agent.y - agent.y[0])
        columns = [*places, *(getattr(agent, key) for key in _COLUMNS)]
        numbers = [float(value) for column in columns for value in column]
        yield f"  {name}: {agent.route_progress[-1]:.9g} m, {array(numbers)}"


_DRIVES = (
    "pure_pursuit { speed: 12m/s }",
    "pure_pursuit { speed: 12m/s, lookahead: 11m }",
    "pure_pursuit { speed: 12m/s, lookahead_time: 0.7s }",
    "pure_pursuit { speed: 20m/s, acceleration: 1.2m/s^2 }",
    "pure_pursuit { speed: 20m/s, acceleration: 6m/s^2, deceleration: 2m/s^2 }",
    "pure_pursuit { speed: 20m/s, acceleration: 6m/s^2, lateral_acceleration: 1.5m/s^2 }",
    "stanley { speed: 12m/s }",
    "stanley { speed: 12m/s, gain: 6/s }",
    "stanley { speed: 12m/s, softening: 6m/s }",
    "stanley { acceleration: 1.2m/s^2 }",
    "stanley { speed: 20m/s, acceleration: 6m/s^2, deceleration: 2m/s^2 }",
    "stanley { speed: 20m/s, acceleration: 6m/s^2, lateral_acceleration: 1.5m/s^2 }",
    "lane_follow { acceleration: 1.2m/s^2 }",
    "lane_follow { speed: 20m/s, acceleration: 6m/s^2, deceleration: 2m/s^2 }",
    "lane_follow { speed: 20m/s, acceleration: 6m/s^2, lateral_acceleration: 1.5m/s^2 }",
    "car_follow { speed: 16m/s }",
    "car_follow { speed: 16m/s, headway: 0.8s }",
    "car_follow { speed: 16m/s, gap: 6m }",
    "car_follow { acceleration: 3.5m/s^2 }",
    "car_follow { speed: 25m/s, acceleration: 3.5m/s^2, deceleration: 4m/s^2 }",
    "car_follow { speed: 25m/s, acceleration: 3.5m/s^2, lateral_acceleration: 1.5m/s^2 }",
    "traffic",
    "traffic { speed: 9m/s }",
    "traffic { speed_factor: 1.3 }",
    "traffic { headway: 2.2s }",
    "traffic { politeness: 1, aggression: 0 }",
    "lane_follow { speed: 14m/s }, drive with brake { when: time > 1s }",
    "lane_follow { speed: 14m/s }, drive with brake { deceleration: 2m/s^2, when: time > 1s }",
    "lane_follow { speed: 14m/s }, drive with brake { speed: 6m/s, when: time > 1s }",
    "car_follow, drive with change_lane { to: left }",
    "car_follow, drive with change_lane { to: right, duration: 2s }",
    "car_follow, drive with change_lane { to: -1, distance: 25m }",
    "car_follow, drive with change_lane { to: left, force: true, when: time > 3s }",
    "car_follow, drive with change_lane { to: left, while: time < 1.5s }",
    "car_follow, drive with cut_in { target: lead }",
    "car_follow { speed: 16m/s }, drive with cut_in { target: lead, gap: 2m, closing: 8m/s }",
    "car_follow, drive with cut_in { target: lead, duration: 1.5s, acceleration: 6m/s^2 }",
    "car_follow { speed: 18m/s }, drive with cut_in { target: lead, deceleration: 1m/s^2 }",
    "car_follow, drive with overtake { target: lead }",
    "car_follow, drive with overtake { target: lead, gap: 3m, speed: 15m/s }",
    "car_follow, drive with overtake { target: lead, duration: 1.5s, acceleration: 5m/s^2 }",
    "car_follow, drive with overtake { target: lead, within: 12m }",
    "car_follow, drive with overtake { target: things }",
    "car_follow, drive with merge",
    "car_follow, drive with merge { to: right, within: 60m, when: time >= 0s }",  # no lane there
    "car_follow, drive with merge { to: -1, speed: 8m/s, duration: 2s }",
    "car_follow { speed: 4m/s }, drive with merge { acceleration: 5m/s^2, within: 80m }",
    "car_follow, drive with merge { deceleration: 6m/s^2, within: 40m, speed: 5m/s }",
    "lane_follow { speed: 12m/s }, drive with stop_at",
    "lane_follow { speed: 12m/s }, drive with stop_at { distance: 50m }",
    "lane_follow { speed: 12m/s }, drive with stop_at { station: 80m, deceleration: 1m/s^2 }",
    "lane_follow, drive with speed_profile { points: [(0m, 12m/s), (30m, 5m/s), (60m, 14m/s)] }",
    "stanley, drive with speed_profile { points: [(0m, 9m/s), (9m, 25m/s)], acceleration: 2m/s^2 }",
    "stanley, drive with speed_profile { points: [(5m, 9m/s), (9m, 0m/s)], deceleration: 3m/s^2 }",
)
_ON_FOOT = (
    "walk",
    "walk { speed: 2.5m/s }",
    "walk { along: edge }",
    "walk { along: edge, beyond: 2m }",
    "walk { along: edge, beyond: -1.5m }",
    "crossing",
    "crossing { speed: 3m/s }",
    "crossing { beyond: 4m, when: time > 2s }",
)
_ROAD = """road r{i} {{
  draw with segments {{
    start: (0m, {y}m)
    pieces: [straight(36m), arc(40m, {turn}deg), clothoid(30m, to: -1/40m), straight(110m)]
  }}
  {lanes}
  speed_limit: 60km/h
}}
agent e{i} is car on r{i} at 10m {{ lane: {lane}, start_speed: 8m/s, drive with {drive} }}
agent lead{i} is van on r{i} at 40m {{ lane: {lead}, drive with lane_follow {{ speed: 5m/s }} }}
agent late{i} is truck on r{i} at {late}m {{
  facing: back
  lane: 2
  drive with car_follow {{ speed: 9m/s }}
}}
object things{i} is parked_car on r{i} at 85m {{ lane: -3 }}
"""
_PATH = """road p{i} {{
  draw with segments {{ start: ({x}m, -80m), pieces: [straight(40m), arc(30m, 80deg)] }}
  {lanes}
}}
agent w{i} is pedestrian on p{i} at 12m {{ side: {side}, offset: 1m, drive with {drive} }}
"""


def option_lines(seconds: float, traffic: str = "right") -> Iterator[str]:
    """Every controller with one option away from its default, each on a road of its own."""
    parts = [f"world {{ traffic: {traffic} }}"]
    for i, drive in enumerate(_DRIVES):
        drive = drive.replace("target: lead", f"target: lead{i}")
        drive = drive.replace("target: things", f"target: things{i}")
        wide = i % 4 != 3
        lane = "-3" if "merge" in drive or "things" in drive else "-2"
        follows = drive.startswith(("car_follow", "traffic")) and "cut_in" not in drive
        lead = lane if follows else "-1"
        lanes = "right: [drive(3.5m), drive(3.25m), drive(3m), sidewalk(2m)], left: [drive, drive]"
        lanes = lanes if wide else "right: [drive, drive, drive, shoulder], left: [drive, drive]"
        numbers = {"y": 250 * i, "turn": (35, -50, 60)[i % 3], "late": 150 + 5 * (i % 7)}
        parts.append(_ROAD.format(i=i, lanes=lanes, lane=lane, lead=lead, drive=drive, **numbers))
    for i, drive in enumerate(_ON_FOOT):
        lanes = "lanes: 2, sidewalks: 2m" if i % 2 else "width: 7m"
        side = "left" if i % 3 else "right"
        parts.append(_PATH.format(i=i, x=-200 * i, lanes=lanes, drive=drive, side=side))
    scenes = testing.sample("\n".join(parts), 1, seed=1)
    driven = scenes[0].run(duration=seconds, control_step=CONTROL_STEP)
    said = {f"e{i}": drive for i, drive in enumerate(_DRIVES)}
    said |= {f"w{i}": drive for i, drive in enumerate(_ON_FOOT)}
    for line in agent_lines(driven.trace):
        name = line.split(":")[0].strip()
        if not name.startswith("things"):
            yield line + (f" {said[name]}" if name in said else "")


_STREETS = [
    [[0.0, 0.0], [50.0, 4.0], [100.0, 0.0]],
    [[190.0, 30.0], [150.0, 8.0], [100.0, 0.0]],
    [[190.0, 30.0], [230.0, 60.0], [290.0, 60.0]],
    [[100.0, -90.0], [110.0, -50.0], [190.0, 30.0]],
]
_ROUTES = """
network town from "right.json" { read with lines, lanes: 4, speed_limit: 50km/h, control with stop }
agent near is car on town { route: [(5m, -2m), (280m, 58m)], drive with traffic }
agent far is car on town { route: [(25m, -5m), (180m, 24m)], drive with traffic }
agent meets is van on town { route: [(285m, 62m), (10m, 5m)], drive with traffic }
agent joins is car on town { route: [(110m, -70m), (20m, 4m)], drive with traffic }
agent turns is car on town { route: [(114m, -55m), (200m, 30m), (280m, 55m)], drive with traffic }
agent laps is car on town { route: [(60m, -2m), (285m, 55m)], lane: outer, drive with traffic }
"""


def street_lines(seconds: float) -> Iterator[str]:
    """Drives along streets that are drawn against each other and join without a junction."""
    text = json.dumps({"lines": _STREETS, "width": 14.0})
    with tempfile.TemporaryDirectory() as name:
        (Path(name) / "right.json").write_text(text, encoding="utf-8")
        scenes = testing.sample(_ROUTES, 1, kinds=[Lines], folder=Path(name), seed=1)
        for actor in scenes[0].record.agents:
            assert actor.route is not None
            steps = [(step.road, step.lane, step.stop) for step in actor.route.steps]
            yield f"{actor.name} {steps}"
        yield from agent_lines(scenes[0].run(duration=seconds).trace)
