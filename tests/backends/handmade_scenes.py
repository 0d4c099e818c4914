"""Scenes made by hand, for tests of backends."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

from roadlang.ir.scene import (
    Provenance,
    Scene,
    SceneActor,
    SceneNetwork,
    SceneNode,
    SceneRoad,
    Verdict,
    ViolatedSegment,
)
from tests.kind_categories import category_of_kind

STATIONS = 400


def road(
    name: str, y: Callable[[float], float], span: float = 240.0, **changes: object
) -> SceneRoad:
    """The graph of `y` over 0 to `span` meters."""
    x = [span * i / (STATIONS - 1) for i in range(STATIONS)]
    points = [(value, y(value)) for value in x]
    return through(name, points, **changes)


def through(name: str, points: list[tuple[float, float]], **changes: object) -> SceneRoad:
    """A road through points, its headings by differences."""
    headings, stations = [], [0.0]
    for (x0, y0), (x1, y1) in pairwise(points):
        headings.append(math.atan2(y1 - y0, x1 - x0))
        stations.append(stations[-1] + math.hypot(x1 - x0, y1 - y0))
    headings.append(headings[-1])
    plain = SceneRoad(
        name=name,
        stations=tuple(stations),
        reference_stations=tuple(stations),
        x=tuple(x for x, _ in points),
        y=tuple(y for _, y in points),
        heading=tuple(headings),
        curvature=tuple(0.0 for _ in points),
        width=tuple(7.0 for _ in points),
        lanes=2,
        closed=False,
        length=stations[-1],
        root=name,
    )
    return replace(plain, **changes)  # type: ignore[arg-type]


def actor(name: str, kind: str, x: float, y: float, **changes: object) -> SceneActor:
    """Something at (x, y) of the size of a car."""
    plain = SceneActor(
        name=name,
        group=name,
        kind=kind,
        x=float(x),
        y=float(y),
        heading=0.0,
        length=4.5,
        width=1.8,
        height=1.5,
        category=category_of_kind(kind),
    )
    return replace(plain, **changes)  # type: ignore[arg-type]


PROVENANCE = Provenance(roadlang="0.1.0", seed=7, scene=0, attempt=3)


def bend(scale: float = 1.0, index: int = 0, amplitude: float = 6.0) -> Scene:
    """A bent road with its original, a car, trees, and one broken expectation."""
    span = 240.0 * scale

    def before(x: float) -> float:
        return 40.0 * scale * math.sin(math.pi * x / span)

    def after(x: float) -> float:
        return before(x) + amplitude * scale * math.sin(4 * math.pi * x / span)

    bent = road("bent", after, span, root="main", derived=True)
    at = STATIONS // 5
    here = {"x": bent.x[at], "y": bent.y[at], "heading": bent.heading[at]}
    trees = tuple(
        actor(f"trees[{i}]", "tree", span * (i + 1) / 13, before(span * (i + 1) / 13) - 14 - i % 3,
              length=5.0, width=5.0, group="trees")
        for i in range(12)
    )  # fmt: skip
    return Scene(
        name="paper",
        title="A bend from an aerial photo, bent further",
        index=index,
        provenance=replace(PROVENANCE, scene=index),
        roads=(road("main", before, span), bent),
        agents=(
            actor("ego", "car", road="bent", start=bent.stations[at],
                  options={"color": "#1f5fa8"}, **here),
        ),
        objects=(*trees, actor("kiosk", "building", 40 * scale, -14, length=12.0, width=8.0)),
        requirements=(
            Verdict("phi1", "always (deviation(bent, main) < 10m)", "road", 4.0, True),
            Verdict("phi3", "always (deviation(bent, main) > 6m implies eventually[20m, 60m] "
                    "always[0m, 15m] (distance(bent, main) < 6m))", "road", 0.25, True),
        ),
        expectations=(
            Verdict("calm", "always (abs(curvature(bent)) < 0.02/m)", "road", -0.0113, False,
                    (ViolatedSegment("bent", 30.0 * scale, 62.0 * scale),
                     ViolatedSegment("bent", 150.0 * scale, 171.0 * scale))),
            Verdict("in_lane", "always (abs(ego.cross_track_error) < 1.5m)", "drive", None, None),
        ),
    )  # fmt: skip


def town() -> Scene:
    """A small network: a crossing, a fork and a bend."""
    nodes = {
        1: (0, 0),
        2: (60, 0),
        3: (60, 50),
        4: (130, 0),
        5: (60, -45),
        6: (160, 40),
        7: (165, -35),
    }
    edges = [(1, 2), (2, 3), (2, 4), (2, 5), (4, 6), (4, 7)]
    roads = []
    for number, (a, b) in enumerate(edges, start=1):
        (x0, y0), (x1, y1) = nodes[a], nodes[b]
        sway = 3.0 if number in (3, 5) else 0.0
        steps = [i / 60 for i in range(61)]
        points = [
            (x0 + t * (x1 - x0), y0 + t * (y1 - y0) + sway * math.sin(math.pi * t)) for t in steps
        ]
        roads.append(through(f"town/{number}", points, network="town", edge=number, derived=True))
    met = {n: tuple(f"town/{i}" for i, e in enumerate(edges, 1) if n in e) for n in nodes}
    network = SceneNetwork(
        "town",
        tuple(SceneNode(n, float(x), float(y), met[n]) for n, (x, y) in nodes.items()),
        tuple(road.name for road in roads),
    )
    buildings = tuple(
        actor(f"house[{i}]", "building", x, y, length=14.0, width=9.0, group="house")
        for i, (x, y) in enumerate([(25, 20), (95, 22), (25, -22), (95, -24)])
    )
    return Scene(
        "town", "", 0, PROVENANCE, networks=(network,), roads=tuple(roads), objects=buildings
    )
