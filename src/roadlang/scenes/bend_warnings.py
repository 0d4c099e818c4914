"""Warnings of agents that cannot stay in their lanes in the bends of their roads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from types import SimpleNamespace

import numpy as np

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..geometry.arrays import Floats
from ..ir.scenario import ScenarioActor
from ..ir.scene import Scene
from ..ir.scene_actor import SceneActor
from ..ir.scene_road import SceneRoad
from ..world.placement.turning import sharpest_turn

_SIZES = ("length", "width", "wheelbase", "max_steering")
_SPACING = 0.5
"""Meters between two points of a lane."""
_OVER = (3.0, 6.0, 12.0)
"""Meters over which bends are averaged."""
_TIGHTEST_TURN = 2.8
"""Radians of a bend, at most: who drives round farther needs no more room."""
_BESIDE = 0.1
"""Meters by which an agent may leave its lane."""


def bend_warnings(
    declared: Sequence[ScenarioActor], scenes: Sequence[Scene]
) -> list[tuple[Diagnostic, ...]]:
    """RL619 for each of some scenes, once for each road and each kind of agent in a group."""
    spans = {actor.name: actor.span for actor in declared}
    tightest: dict[tuple[int, int], float] = {}
    return [tuple(_found(spans, scene, tightest)) for scene in scenes]


def _found(
    spans: Mapping[str, Span | None], scene: Scene, tightest: dict[tuple[int, int], float]
) -> Iterator[Diagnostic]:
    """`tightest`: what is known of roads, which many scenes may share, by the identity of their
    curvatures and widths."""
    roads = {road.name: road for road in scene.roads if not road.along}
    known: set[tuple[str, str, str]] = set()
    for agent in scene.agents:
        if not agent.drive:
            continue
        limit = _sharpest_turn(*map(agent.options.get, _SIZES))
        for road, lane, low, high in _driven(agent, roads):
            if (place := (id(road.curvature), id(road.width))) not in tightest:
                tightest[place] = _tightest(road)
            key = agent.group, agent.kind, road.name
            if tightest[place] <= limit or key in known:
                continue
            aside = _aside(_line(road, lane, low, high), 1.0 / limit, agent.route is not None)
            if aside > _room(road, lane, low, high, agent.width) + _BESIDE:
                known.add(key)
                yield diagnose(
                    Code.BEND_TOO_TIGHT,
                    spans.get(agent.group),
                    name=agent.group,
                    kind=agent.kind,
                    road=road.name,
                    radius=f"{1.0 / limit:.1f}m",
                )


@lru_cache(maxsize=256)
def _sharpest_turn(*sizes: object) -> float:
    return sharpest_turn(SimpleNamespace(**dict(zip(_SIZES, sizes, strict=True))))


def _tightest(road: SceneRoad) -> float:
    """1/m: no line beside the center line of a road bends more, as far as the road is wide."""
    bend = max(max(road.curvature), -min(road.curvature))
    return bend / max(1.0 - bend * max(road.width), 1e-3)


def _driven(
    agent: SceneActor, roads: Mapping[str, SceneRoad]
) -> Iterator[tuple[SceneRoad, int, float, float]]:
    """Roads and lanes that an agent may drive, and between which arc lengths."""
    if agent.route is not None:
        for step in agent.route.steps:
            low, high = sorted((step.start, step.stop))
            yield roads[step.road], step.lane, low, high
        return
    road = roads.get(agent.road or "")
    if road is not None and agent.lane and agent.start is not None:
        backward = agent.facing == "back"
        low = 0.0 if backward or road.closed else agent.start
        yield road, agent.lane, low, agent.start if backward and not road.closed else road.length


def _line(road: SceneRoad, lane: int, low: float, high: float) -> Floats:
    """x, y and heading (n, 3) of the middle of a lane between two arc lengths; all around a closed
    road twice, with the bend where it ends; (0, 3) where there is no lane."""
    section = road.cross_section()
    s = np.asarray(road.stations)
    there = (s >= low) & (s <= high)
    if lane not in section.ids or not there.any():
        return np.zeros((0, 3))
    offset, heading = section.offset(lane, s), np.unwrap(road.heading)
    x, y = road.x - np.sin(heading) * offset, road.y + np.cos(heading) * offset
    line = np.stack((x, y, heading), axis=1)[there]
    if not (road.closed and there.all()):
        return line
    turned = 2.0 * np.pi * np.round((heading[-1] - heading[0]) / (2.0 * np.pi))
    return np.concatenate((line, line + np.array([0.0, 0.0, turned])))


def _room(road: SceneRoad, lane: int, low: float, high: float, width: float) -> float:
    """Meters between the side of an agent in the middle of a lane and the border of the lane, where
    that is widest."""
    section = road.cross_section()
    s = np.asarray(road.stations)
    there = (s >= low) & (s <= high)
    return max(0.5 * (float(section.lane_width(lane, s[there]).max(initial=0.0)) - width), 0.0)


def _aside(line: Floats, least: float, cuts: bool) -> float:
    """Meters by which who needs the radius `least` leaves a line in its bends.

    A bend of radius `r` by the angle `a` lies within an arc of a greater radius `R` that begins
    before it and ends after it, which is `(R - r) (1 / cos(a / 2) - 1)` inside of its middle. Who
    does not cut bends, as agents without routes, is `(R - r) (1 - cos a)` outside at its end.
    """
    if not len(line):
        return 0.0
    steps = np.hypot(*np.diff(line[:, :2], axis=0).T)
    gone = np.concatenate(([0.0], np.cumsum(steps)))
    along = np.interp(np.arange(0.0, gone[-1], _SPACING), gone, line[:, 2])
    most = 0.0
    for over in _OVER:
        count = round(over / _SPACING)
        angle = float(np.abs(along[count:] - along[:-count]).max(initial=0.0))
        spare = least - over / max(angle, 1e-9)
        turned = min(angle, _TIGHTEST_TURN)
        share = 1.0 / np.cos(0.5 * turned) - 1.0 if cuts else 1.0 - np.cos(turned)
        most = max(most, spare * float(share))
    return most
