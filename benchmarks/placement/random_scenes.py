"""Random scene files with 5 to 60 agents and objects: bends, cross-sections, rows, groups."""

from __future__ import annotations

import random

AGENTS = ("car", "van", "truck", "bus", "motorcycle", "bicycle", "choice(car, truck)")
BESIDE = ("tree", "building", "lamp", "bench", "bus_stop", "parked_car", "choice(bush, rock)")
NETWORK = '''image plan from """
....#.....#....
....#.....#....
###############
....#.....#....
....#.....#....
""" { scale: 25m/px, legend: { "#": road } }
network main from plan { lanes: 2, sidewalks: 2m, speed_limit: 50km/h }
'''


def scene_text(number: int) -> str:
    """The scene file of a number."""
    rng = random.Random(number)
    on_network = rng.random() < 0.2
    lines = [NETWORK if on_network else _road(rng)]
    left = rng.randint(5, 60)
    part = 0
    while left > 0:
        part += 1
        count = rng.randint(1, min(left, 20))
        left -= count
        if rng.random() < 0.45:
            lines.append(_agents(rng, part, count, on_network))
        else:
            lines.append(_objects(rng, part, count, on_network))
    return "\n".join(lines)


def _road(rng: random.Random) -> str:
    pieces = ["straight(120m)"]
    for _ in range(rng.randint(1, 4)):
        angle = rng.choice((-1, 1)) * rng.randint(20, 80)
        pieces += [
            f"arc({rng.randint(60, 250)}m, {angle}deg)",
            f"straight({rng.randint(60, 200)}m)",
        ]
    section = rng.choice((
        "lanes: 2", "lanes: 4", "lanes: 3, oneway: true", "lanes: 2, sidewalks: 2m",
        "left: [drive, bike, sidewalk], right: [drive, drive, parking, sidewalk]",
    ))  # fmt: skip
    return f"road main {{ draw with segments {{ pieces: [{', '.join(pieces)}] }}, {section} }}"


def _agents(rng: random.Random, part: int, count: int, on_network: bool) -> str:
    kind = rng.choice(AGENTS)
    options = [f"count: {count}"]
    if not on_network and rng.random() < 0.4:
        options.append("facing: choice(forward, back)")
    if rng.random() < 0.3:
        options.append(f"apart: {rng.randint(1, 4)}m")
    drive = "drive with traffic" if on_network else "drive with car_follow"
    return f"agent a{part} is {kind} on main at random {{ {', '.join(options)}, {drive} }}"


def _objects(rng: random.Random, part: int, count: int, on_network: bool) -> str:
    kind, far = rng.choice(BESIDE), rng.randint(4, 30)
    place = f"side: choice(left, right), offset: 0.5m..{far}m"
    turned = ", heading: 0deg..360deg" if rng.random() < 0.5 else ""
    return f"object o{part} is {kind} on main at random {{ count: {count}, {place}{turned} }}"
