"""Named kinds of plan: what lies where, in meters, before anything is painted."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from training.rendering.frame import Floats, PlannedRoad
from training.rendering.layouts.curves import arc, crossing, even, spline
from training.rendering.layouts.growth import Style, grown

Plan = list[PlannedRoad]


def bend(rng: np.random.Generator, extent: float) -> Plan:
    """One road with a hairpin, from edge to edge."""
    turn = rng.uniform(0, 2 * np.pi)
    tip, gap = rng.uniform(0.16, 0.3), rng.uniform(0.1, 0.16)
    shape = np.array(
        [
            *([-0.8, -gap - 0.22], [-0.35, -gap - 0.08], [tip - 0.1, -gap], [tip + 0.02, 0.0]),
            *([tip - 0.1, gap], [-0.35, gap + 0.05], [-0.8, gap + 0.3]),
        ]
    )
    shape[1:-1] += rng.normal(0, 0.012, (5, 2))
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    points = spline(extent * (0.5 + shape @ rotation.T))
    return [PlannedRoad(points, rng.uniform(6, 9))]


def curve(rng: np.random.Generator, extent: float) -> Plan:
    """One winding road."""
    return [PlannedRoad(crossing(rng, extent, 6e-3), rng.uniform(5, 9))]


def rural(rng: np.random.Generator, extent: float) -> Plan:
    """A few winding roads, far apart."""
    style = Style(rng.uniform(130, 260), 3e-3, 500, int(rng.integers(1, 6)), (4.0, 7.5))
    return grown(rng, extent, style)


def suburb(rng: np.random.Generator, extent: float) -> Plan:
    """Curving streets, crescents and turning circles."""
    spacing = rng.uniform(75, 140)
    count = int((extent / spacing) ** 2 * rng.uniform(0.6, 1.2)) + 3
    style = Style(spacing, rng.uniform(3e-3, 1e-2), 300, count, (6.0, 9.0), int(rng.integers(1, 3)))
    return grown(rng, extent, style)


def village(rng: np.random.Generator, extent: float) -> Plan:
    """Old streets that meet at odd angles, close together."""
    spacing = rng.uniform(55, 90)
    count = int((extent / spacing) ** 2 * rng.uniform(0.5, 0.9)) + 3
    style = Style(spacing, 4e-3, 200, count, (4.5, 8.0), int(rng.integers(2, 4)), 0.1)
    return grown(rng, extent, style)


def grid(rng: np.random.Generator, extent: float) -> Plan:
    """Blocks, a little warped, some of their edges missing, some streets wide."""
    turn, pitch = rng.uniform(0, np.pi / 2), rng.uniform([55, 75], [110, 200])
    wave = rng.uniform(0, 18) * rng.standard_normal((2, 2)), rng.uniform(0.4, 1.2, 2) / extent
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    base = rng.uniform(6.0, 10.0)

    def placed(uv: Floats) -> Floats:
        bent = uv + wave[0][0] * np.sin(2 * np.pi * wave[1][0] * uv[:, ::-1])
        return np.asarray(0.5 * extent + (bent - 0.5 * extent) @ rotation.T)

    plan: Plan = []
    for axis in (0, 1):
        lines = np.arange(-extent, 2 * extent, pitch[axis]) + rng.normal(0, 0.08 * pitch[axis])
        lines = lines + rng.normal(0, 0.06 * pitch[axis], len(lines))
        cuts = np.arange(-extent, 2 * extent, pitch[1 - axis])
        for line in lines:
            width = rng.uniform(12, 20) if rng.random() < 0.12 else base * rng.uniform(0.8, 1.2)
            for low, high in _kept_blocks(rng, cuts, 0.1 if width < 12 else 0.0):
                along = np.arange(low, high + 1, 2.0)
                uv = np.c_[along, np.full_like(along, line)]
                points = placed(uv[:, ::-1] if axis else uv)
                if _visible(points, extent):
                    plan.append(PlannedRoad(even(points), width))
    return plan


def city(rng: np.random.Generator, extent: float) -> Plan:
    """Dense blocks: a close grid, or old streets, with wide avenues between."""
    if rng.random() < 0.35:
        spacing = rng.uniform(45, 75)
        count = int((extent / spacing) ** 2 * rng.uniform(0.7, 1.1)) + 3
        style = Style(spacing, 3e-3, 250, count, (5.5, 9.0), int(rng.integers(2, 4)), 0.03)
        avenue = PlannedRoad(crossing(rng, extent, 8e-4), rng.uniform(11, 22))
        return grown(rng, extent, style, (avenue,))
    return grid(rng, extent)


def _kept_blocks(rng: np.random.Generator, cuts: Floats, loss: float) -> list[tuple[float, float]]:
    runs, start = [], cuts[0]
    for here, after in pairwise(cuts):
        if rng.random() < loss:
            if here > start:
                runs.append((start, here))
            start = after
    return [*runs, (start, cuts[-1])]


def _visible(points: Floats, extent: float) -> bool:
    return bool(((points > -20) & (points < extent + 20)).all(axis=1).any())


def motorway(rng: np.random.Generator, extent: float) -> Plan:
    """Two carriageways, a road across, ramps, and a town beside."""
    axis = crossing(rng, extent, 8e-4)
    width, gap = rng.uniform(9, 15), rng.uniform(14, 32)
    normal = np.gradient(axis, axis=0)
    normal = np.c_[-normal[:, 1], normal[:, 0]] / np.hypot(*normal.T)[:, None]
    ways = [PlannedRoad(even(axis + s * gap / 2 * normal), width, "motorway") for s in (-1, 1)]
    middle = len(axis) // 2 + int(rng.integers(-40, 40))
    middle = int(np.clip(middle, 5, len(axis) - 6))
    across = spline(axis[middle] + np.outer(np.linspace(-1, 1, 7) * 0.9 * extent, normal[middle]))
    ramps = _ramps(rng, axis[middle], normal[middle], gap / 2 + width / 2)
    bridge = PlannedRoad(across, rng.uniform(8, 14))
    spacing = rng.uniform(80, 160)
    style = Style(spacing, 4e-3, 300, int((extent / spacing) ** 2 * 0.5) + 2, (6.0, 9.0), 0)
    town = grown(rng, extent, style, (bridge,))
    clear = [road for road in town[1:] if _apart(road.points, axis, gap / 2 + width + 12)]
    return [*clear, bridge, *ramps, *ways]


def boulevard(rng: np.random.Generator, extent: float) -> Plan:
    """A divided road with a narrow median through a town, sometimes crossed by another."""
    ways: Plan = []
    for _ in range(1 if rng.random() < 0.7 else 2):
        axis = crossing(rng, extent, 1.5e-3)
        width, median = rng.uniform(6, 12), rng.uniform(1.5, 10)
        normal = np.gradient(axis, axis=0)
        normal = np.c_[-normal[:, 1], normal[:, 0]] / np.hypot(*normal.T)[:, None]
        apart = (width + median) / 2 * normal
        ways += [PlannedRoad(even(axis + side * apart), width) for side in (-1, 1)]
    spacing = rng.uniform(60, 140)
    count = int((extent / spacing) ** 2 * rng.uniform(0.5, 1.0)) + 3
    style = Style(spacing, 2e-3, 300, count, (6.0, 10.0), int(rng.integers(0, 3)), 0.05)
    return grown(rng, extent, style, tuple(ways))


def _ramps(rng: np.random.Generator, center: Floats, normal: Floats, edge: float) -> Plan:
    tangent = np.array([normal[1], -normal[0]])
    ramps: Plan = []
    for side in (-1, 1):
        for hand in (-1, 1):
            if rng.random() < 0.45:
                continue
            radius = rng.uniform(28, 50)
            out, along = side * normal, hand * tangent
            loop = center + out * (edge + radius) + along * (radius + 4)
            start = float(np.arctan2(*(-out)[::-1]))
            sweep = -np.sign(out[0] * along[1] - out[1] * along[0]) * 1.5 * np.pi
            ramps.append(PlannedRoad(arc(loop, radius, start, sweep), rng.uniform(5, 7), "ramp"))
    return ramps


def _apart(points: Floats, axis: Floats, least: float) -> bool:
    away = points[::4, None] - axis[None, ::4]
    return bool(np.hypot(away[..., 0], away[..., 1]).min() > least)


def roundabout(rng: np.random.Generator, extent: float) -> Plan:
    """A circle with arms, streets grown from them."""
    center, radius = rng.uniform(0.35, 0.65, 2) * extent, rng.uniform(12, 25)
    plan: Plan = []
    start = rng.uniform(0, 2 * np.pi)
    arms = int(rng.integers(3, 6))
    for angle in start + np.arange(arms) * 2 * np.pi / arms + rng.normal(0, 0.12, arms):
        out = np.array([np.cos(angle), np.sin(angle)])
        side = np.array([-out[1], out[0]]) * rng.normal(0, 0.06 * extent)
        reach = np.array([radius, 0.3 * extent, 0.7 * extent, 1.2 * extent])
        points = spline(center + np.outer(reach, out) + np.outer([0, 0.1, 0.6, 1.5], side))
        plan.append(PlannedRoad(points, rng.uniform(6, 9)))
    spacing = rng.uniform(80, 140)
    style = Style(spacing, 4e-3, 250, arms + int((extent / spacing) ** 2 * 0.4), (6, 9), 0)
    ring = PlannedRoad(arc(center, radius, 0, 2 * np.pi), rng.uniform(6, 9), "ring", True)
    return [*grown(rng, extent, style, tuple(plan)), ring]


PLANS: dict[str, Callable[[np.random.Generator, float], Plan]] = {
    "bend": bend,
    "curve": curve,
    "rural": rural,
    "suburb": suburb,
    "village": village,
    "grid": grid,
    "motorway": motorway,
    "roundabout": roundabout,
    "city": city,
    "boulevard": boulevard,
}
