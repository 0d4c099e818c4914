"""Random traffic scenes, as scene files: typed maps and drawings, all rules, all vehicles."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from random import Random

import cv2

from roadlang import testing

from .drawings import DRAWINGS
from .plans import PLANS

CONTROLS = (
    "",
    "control with signals "
    "{{ green: {green}s, yellow: {yellow}s, all_red: {red}s, offset: {start}s }}",
    "control with yield",
    "control with stop",
    "control with all_way_stop",
)
KINDS = (
    "car",
    "choice(car, van, weights: [4, 1])",
    "choice(car, van, truck, bus, motorcycle, weights: [6, 2, 1, 1, 1])",
    "choice(car, truck, bus, bicycle, motorcycle, weights: [3, 2, 2, 2, 1])",
)
SECTION = "[drive(3.5m), parking(2.4m), sidewalk(2m)]"
"""One side of a street with parked cars."""
DRIVES = (
    "drive with traffic { speed_factor: 0.7..1.2, aggression: 0..1, politeness: 0..1, "
    "headway: 0.6s..1.8s }"
)
PICTURE = "plan.png"
LANE = 3.5
"""Meters."""


@dataclass(frozen=True)
class TrafficScene:
    """A scene file."""

    text: str
    roads: str
    """what they are like"""
    rule: str
    """at their junctions"""


def random_scene(seed: int, folder: Path) -> TrafficScene:
    """The same for one seed. The picture that it may name is written to the folder."""
    draw = Random(f"traffic {seed}")
    name = draw.choice((*PLANS, *DRAWINGS))
    drawn = name in DRAWINGS
    lanes = draw.choice((2, 2, 2, 2, 3, 4, 4) if drawn else (2, 2, 2, 2, 3, 4, 4, 6))
    if drawn:
        cv2.imwrite(str(folder / PICTURE), DRAWINGS[name](draw, lanes * LANE))
        source = f'image plan from "{PICTURE}" {{ scale: 0.5m/px, legend: {{ "white": road }} }}'
    else:
        plan = PLANS[name](draw)
        source = f'image plan from """\n{plan}\n""" {{ scale: {max(8.0, LANE * lanes)}m/px }}'
    control = draw.choice(CONTROLS).format(
        green=draw.randint(4, 24), yellow=draw.choice((0, 1, 2, 3, 4)),
        red=draw.choice((0, 1, 2)), start=draw.randint(0, 60),
    )  # fmt: skip
    is_street = lanes == 2 and draw.random() < 0.25
    oneway = (
        not is_street
        and name in ("star", "ramp", "close_pair", "crossing")
        and draw.random() < 0.15
    )
    options = (
        "extract with pixels" if drawn else "",
        f"left: {SECTION}, right: {SECTION}" if is_street else f"lanes: {lanes}",
        f"speed_limit: {draw.choice((30, 50, 50, 60, 70))}km/h",
        "oneway: true" if oneway else "",
        "sidewalks: 2m" if not is_street and draw.random() < 0.3 else "",
        control,
    )
    network = "\n".join(("network town from plan {", *filter(None, options), "}"))
    side = "world { traffic: left }" if draw.random() < 0.3 else ""
    roads = "\n".join((source, network, side))
    agents = _agents(draw, _junctions(roads, folder))
    text = "\n".join((roads, *agents, *_beside(draw, is_street), ""))
    rule = control.split()[2] if control else "right_first"
    return TrafficScene(text, f"{name} of {lanes} lanes", rule)


def _junctions(roads: str, folder: Path) -> list[int]:
    """Ids of those that a lane leads into."""
    (scene,) = testing.sample(
        roads + "\nagent nobody is car on town at random { route_length: 20m }", 1, folder=folder
    )
    places = scene.record.networks[-1].junctions
    return [one.id for one in places if one.kind != "joint" and one.connections]


def _agents(draw: Random, junctions: list[int]) -> list[str]:
    """Five to sixty cars, vans, trucks and buses; some close to a junction, some slow."""
    count = draw.choice((5, 8, 12, 16, 20, 24, 30, 40, 60))
    near = draw.randint(0, min(3, count - 3)) if junctions else 0
    slow = draw.randint(0, 2)
    kinds = draw.choice(KINDS)
    length = draw.choice((300, 1500))
    rows = [
        f"agent cars is {kinds} on town at random "
        f"{{ count: {count - near - slow}, route_length: {length}m, {DRIVES} }}"
    ]
    for number in range(near):
        before = draw.choice(("0m..8m", "2m..30m", "5m..60m"))
        place = f"junction({draw.choice(junctions)}, before: {before})"
        rows.append(f"agent near{number} is {kinds} on town at {place} {{ {DRIVES} }}")
    if slow:
        drives = "drive with traffic { speed: 4m/s..7m/s }"
        rows.append(f"agent slow is bicycle on town at random {{ count: {slow}, {drives} }}")
    return rows


def _beside(draw: Random, is_street: bool) -> list[str]:
    """Long trucks, parked cars, things beside the road, people who cross it somewhere."""
    rows = []
    if draw.random() < 0.3:
        long = f"length: {draw.choice(('7m', '10m', '14m'))}, {DRIVES}"
        rows.append(f"agent long is truck on town at random {{ count: 2, {long} }}")
    if is_street:
        rows.append(
            "object parked is choice(parked_car, parked_van) on town at random "
            f"{{ lane: parking, count: {draw.randint(2, 12)} }}"
        )
    elif draw.random() < 0.4:
        side = draw.choice(("left", "right"))
        rows.append(f"object cones is cone on town at random {{ count: 4, side: {side} }}")
    if draw.random() < 0.4:
        when = f"when: time > {draw.randint(2, 20)}s"
        walks = f"drive with crossing {{ speed: 0.8m/s..1.8m/s, {when} }}"
        rows.append(
            f"agent people is pedestrian on town at random {{ side: right, offset: 1m, "
            f"count: {draw.randint(1, 4)}, {walks} }}"
        )
    return rows
