"""Scenes for the tests of the engine, made directly of the IR."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from roadlang.api import Call, Scene, SceneActor, SceneNetwork, SceneNode, SceneRoad
from roadlang.ir.scene import Provenance
from tests.kind_categories import category_of_kind

PROVENANCE = Provenance(roadlang="0.1.0", seed=1, scene=0, attempt=0)


def straight(length: float) -> tuple[float, float]:
    """A piece of road: its length and curvature."""
    return (length, 0.0)


def bend(radius: float, degrees: float) -> tuple[float, float]:
    """A piece of road on a circle; right bends have a negative radius."""
    return (abs(radius) * math.radians(degrees), 1.0 / radius)


def pieces(
    *parts: tuple[float, float], start: tuple[float, float] = (0.0, 0.0), heading: float = 0.0
) -> np.ndarray:
    """(n, 2) points half a meter apart along pieces of constant curvature."""
    x, y = start
    points = [(x, y)]
    for length, curvature in parts:
        count = max(1, round(length / 0.5))
        step = length / count
        for _ in range(count):
            middle = heading + 0.5 * step * curvature
            x, y = x + step * math.cos(middle), y + step * math.sin(middle)
            heading += step * curvature
            points.append((x, y))
    return np.array(points)


def road(
    name: str,
    points: np.ndarray,
    width: float = 7.0,
    lanes: int = 2,
    closed: bool = False,
    **more: Any,
) -> SceneRoad:
    """A road through points that lie close together."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    s = np.concatenate([[0.0], np.cumsum(steps)])
    tangent = np.gradient(points, s, axis=0)
    heading = np.unwrap(np.arctan2(tangent[:, 1], tangent[:, 0]))
    length = float(s[-1])
    if closed:
        length += float(np.hypot(*(points[0] - points[-1])))
    return SceneRoad(
        name=name,
        stations=tuple(s),
        reference_stations=tuple(s),
        x=tuple(points[:, 0]),
        y=tuple(points[:, 1]),
        heading=tuple(heading),
        curvature=tuple(np.gradient(heading, s)),
        width=(width,) * len(s),
        lanes=lanes,
        closed=closed,
        length=length,
        root=name,
        **{"derived": True, **more},
    )


def call(kind: str, when: Mapping[str, Any] | None = None, **options: float) -> Call:
    """A controller with its options."""
    return Call(f"roadlang.{kind}", options, when)


def car(
    name: str, on: SceneRoad, at: float, *drive: Call, kind: str = "car", **more: Any
) -> SceneActor:
    """An agent on a road."""
    i = int(np.searchsorted(on.stations, at))
    heading = on.heading[i]
    offset = more.get("offset") or 0.0
    size = {"pedestrian": (0.5, 0.5, 1.8)}.get(kind, (4.5, 1.8, 1.5))
    group = name.partition("[")[0]
    return SceneActor(
        name=name,
        group=group,
        kind=kind,
        x=on.x[i] - math.sin(heading) * offset,
        y=on.y[i] + math.cos(heading) * offset,
        heading=heading,
        length=size[0],
        width=size[1],
        height=size[2],
        category=category_of_kind(kind),
        road=on.name,
        start=at,
        options={} if kind == "pedestrian" else {"mass": 1200.0, "wheelbase": 2.7},
        drive=drive,
        **more,
    )


def thing(
    kind: str,
    x: float,
    y: float,
    length: float = 4.0,
    width: float = 4.0,
    height: float = 6.0,
    name: str = "",
) -> SceneActor:
    """An object in the world."""
    shown = name or f"{kind}s[{x:g}]"
    return SceneActor(
        shown, shown.partition("[")[0], kind, x, y, 0.0, length, width, height,
        category=category_of_kind(kind),
    )  # fmt: skip


def scene(
    *roads: SceneRoad,
    agents: Iterable[SceneActor] = (),
    objects: Iterable[SceneActor] = (),
    networks: Iterable[SceneNetwork] = (),
    **more: Any,
) -> Scene:
    """A scene of these parts."""
    return Scene(
        name="test",
        title="",
        index=0,
        provenance=PROVENANCE,
        roads=roads,
        agents=tuple(agents),
        objects=tuple(objects),
        networks=tuple(networks),
        **more,
    )


def bends() -> SceneRoad:
    """870 m with bends down to a radius of 37 m."""
    parts = (
        straight(80), bend(37, 90), straight(60), bend(-37, 90), straight(100), bend(-37, 60),
        straight(40), bend(60, 120), straight(100), bend(-37, 90), straight(150),
    )  # fmt: skip
    return road("bends", pieces(*parts))


def town() -> tuple[tuple[SceneRoad, ...], SceneNetwork]:
    """A crossing of four roads, one arm of which forks."""
    ends = {2: (120.0, 0.0), 3: (0.0, 90.0), 4: (-80.0, -20.0), 5: (10.0, -100.0)}
    forks = {6: (200.0, 40.0), 7: (190.0, -60.0)}
    made: list[SceneRoad] = []
    nodes: dict[int, list[str]] = {1: []}

    def add(start: int, end: int, a: tuple[float, float], b: tuple[float, float]) -> None:
        name = f"town/{len(made) + 1}"
        t = np.linspace(0, 1, 101)[:, None]
        points = np.array(a) * (1 - t) + np.array(b) * t
        made.append(road(name, points, network="town", edge=len(made) + 1))
        nodes.setdefault(start, []).append(name)
        nodes.setdefault(end, []).append(name)

    for number, place in ends.items():
        add(1, number, (0.0, 0.0), place)
    for number, place in forks.items():
        add(number, 2, place, ends[2])
    places = {1: (0.0, 0.0), **ends, **forks}
    network = SceneNetwork(
        "town",
        tuple(SceneNode(n, *places[n], tuple(names)) for n, names in nodes.items()),
        tuple(one.name for one in made),
    )
    return tuple(made), network
