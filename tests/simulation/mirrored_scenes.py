"""Random scenes and their mirror images: the same text with the left and the right exchanged."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any, ClassVar

from roadlang.api import Reader
from roadlang.geometry import RoadNetwork, network_of_polylines

Point = tuple[float, float]
ARM = 110.0
"""Meters from the middle to the end of an arm."""


@dataclass(frozen=True)
class Lines(Reader):
    """A network of the lines in a JSON file."""

    name: ClassVar[str] = "lines"
    reads: ClassVar[tuple[str, ...]] = ("network",)

    def read(self, path: Path) -> RoadNetwork:
        found = json.loads(path.read_text())
        return network_of_polylines(found["lines"], found["width"])


@dataclass(frozen=True)
class Pair:
    """A scene for right-hand traffic and its mirror image for left-hand traffic."""

    right: str
    left: str
    lines: list[list[Point]]
    width: float

    def write(self, folder: Path) -> None:
        """The files that both name."""
        for name, sign in (("right", 1.0), ("left", -1.0)):
            lines = [[(sign * x, y) for x, y in line] for line in self.lines]
            text = json.dumps({"lines": lines, "width": self.width})
            (folder / f"{name}.json").write_text(text)


def random_pair(seed: int) -> Pair:
    """The same for one seed."""
    draw = Random(f"pair {seed}")
    layout = LAYOUTS[seed % len(LAYOUTS)]
    rule = RULES[seed // len(LAYOUTS) % len(RULES)]
    lanes = draw.choice((2, 2, 4))
    lines, headings = layout(draw)
    width = 3.5 * lanes
    rows = [*_cars(draw, headings, lanes), *_others(draw, headings, width)]

    def text(side: str, sign: float) -> str:
        made = [row(sign) for row in rows]
        network = (
            f'network town from "{side}.json" {{\n  read with lines\n  lanes: {lanes}\n'
            f"  speed_limit: 50km/h\n  {rule}\n}}"
        )
        return "\n".join((network, *made, f"world {{ traffic: {side} }}"))

    return Pair(text("right", 1.0), text("left", -1.0), lines, width)


RULES = (
    "",
    "control with signals { green: 7s, yellow: 3s, all_red: 1s, offset: 4s }",
    "control with yield",
    "control with stop",
    "control with all_way_stop",
)


def _cross(draw: Random) -> tuple[list[list[Point]], list[float]]:
    turned = draw.uniform(0.1, 0.4)
    return _star([turned + k * math.pi / 2 + draw.uniform(-0.2, 0.2) for k in range(4)])


def _fork(draw: Random) -> tuple[list[list[Point]], list[float]]:
    turned = draw.uniform(0.1, 0.4)
    return _star([turned, turned + math.pi + draw.uniform(-0.2, 0.2), turned + 1.7])


def _roundabout(draw: Random) -> tuple[list[list[Point]], list[float]]:
    radius = draw.uniform(20.0, 30.0)
    turned = draw.uniform(0.1, 0.4)
    headings = [turned + k * math.pi / 2 + draw.uniform(-0.15, 0.15) for k in range(4)]
    lines = [[_polar(radius, h), _polar(ARM, h)] for h in headings]
    for first, second in zip(headings, [*headings[1:], headings[0] + 2.0 * math.pi], strict=True):
        share = [first + (second - first) * k / 24 for k in range(25)]
        lines.append([_polar(radius, h) for h in share[:-1]] + [_polar(radius, second)])
    lines[-1][-1] = lines[4][0]
    return lines, headings


def _bend(draw: Random) -> tuple[list[list[Point]], list[float]]:
    """One road that bends, without a junction."""
    first = draw.uniform(0.1, 0.4)
    headings = [first, first + draw.uniform(2.2, 2.8)]
    corner = [_polar(12.0, headings[0]), (0.0, 0.0), _polar(12.0, headings[1])]
    smooth = [
        tuple((1 - t) ** 2 * a + 2 * t * (1 - t) * b + t * t * c
              for a, b, c in zip(*corner, strict=True))
        for t in (k / 12 for k in range(13))
    ]  # fmt: skip
    away = [12.0 + (ARM - 12.0) * k / 9 for k in range(1, 10)]
    line: list[Any] = [
        *[_polar(distance, headings[0]) for distance in reversed(away)],
        *smooth,
        *[_polar(distance, headings[1]) for distance in away],
    ]
    return [line], headings


LAYOUTS = (_cross, _fork, _roundabout, _bend)


def _star(headings: list[float]) -> tuple[list[list[Point]], list[float]]:
    return [[(0.0, 0.0), _polar(ARM, heading)] for heading in headings], headings


def _polar(distance: float, heading: float) -> Point:
    return distance * math.cos(heading), distance * math.sin(heading)


def _beside(heading: float, distance: float, right: float) -> Point:
    """A place on an arm, so far right of it as one sees who comes to the middle."""
    x, y = _polar(distance, heading)
    return x - right * math.sin(heading), y + right * math.cos(heading)


def _cars(draw: Random, headings: list[float], lanes: int) -> list[Any]:
    rows = []
    for number, heading in enumerate(headings):
        for place in range(3):
            start = 40.0 + 20.0 * place + draw.uniform(0.0, 8.0)
            lane = draw.randrange(lanes // 2)
            goal = draw.choice([one for one in headings if one != heading])
            begin = _beside(heading, start, 3.5 * (lane + 0.5))
            end = _beside(goal, ARM - 5.0, -1.75)
            kind = draw.choice(("car", "car", "van"))
            drives = f"drive with traffic {{ aggression: {draw.random():.3f} }}"
            if lanes == 4 and draw.random() < 0.3:
                side = "left" if lane else "right"
                drives += f", drive with change_lane {{ to: {side}, when: time > 3s }}"
            elif draw.random() < 0.2:
                drives += (
                    ", drive with brake { deceleration: 3m/s^2, while: 4s < time and time < 6s }"
                )
            rows.append(_row(f"car{number}_{place}", kind, drives, begin, end))
    return rows


def _row(name: str, kind: str, drives: str, begin: Point, end: Point) -> Any:
    def text(sign: float) -> str:
        words = drives if sign > 0.0 else _swapped(drives)
        places = ", ".join(f"({sign * x:.6f}m, {y:.6f}m)" for x, y in (begin, end))
        return f"agent {name} is {kind} on town {{ route: [{places}], {words} }}"

    return text


def _others(draw: Random, headings: list[float], width: float) -> list[Any]:
    """Somebody who crosses an arm, and what stands beside and on the roads."""
    heading = draw.choice(headings)
    foot = _beside(heading, 30.0, 0.5 * width + 1.5)
    across = heading - math.pi / 2
    stands = _beside(headings[0], 90.0, -0.5 * width - 2.0)
    seconds = draw.uniform(2.0, 8.0)

    def walker(sign: float) -> str:
        x, y = sign * foot[0], foot[1]
        turned = across if sign > 0.0 else math.pi - across
        return (
            f"agent walker is pedestrian at ({x:.6f}m, {y:.6f}m) {{ heading: {turned:.9f}rad, "
            f"drive with crossing {{ speed: 1.4m/s, when: time > {seconds:.3f}s }} }}"
        )

    def thing(sign: float) -> str:
        x, y = sign * stands[0], stands[1]
        turned = headings[0] if sign > 0.0 else math.pi - headings[0]
        return f"object van is parked_van at ({x:.6f}m, {y:.6f}m) {{ heading: {turned:.9f}rad }}"

    return [walker, thing]


def _swapped(text: str) -> str:
    other = {"left": "right", "right": "left"}
    words = text.split(" ")
    return " ".join(other[w.rstrip(",")] + w[len(w.rstrip(",")):] if w.rstrip(",") in other else w
                    for w in words)  # fmt: skip
