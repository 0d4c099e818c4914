"""Towns that grow: streets leave streets, turn, meet others, or end in a turning circle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from training.rendering.frame import Floats, PlannedRoad
from training.rendering.layouts.curves import STEP, arc, crossing, even, spline

_STRIDE = 6.0


@dataclass(frozen=True)
class Style:
    """How a town grows, in meters: spacing of streets, wandering of their curvature, widths."""

    spacing: float
    bend: float
    length: float
    streets: int
    widths: tuple[float, float]
    arterials: int = 1
    turning_circles: float = 0.4


class _Town:
    def __init__(self, rng: np.random.Generator, extent: float, style: Style) -> None:
        self.rng, self.extent, self.style = rng, extent, style
        self.roads: list[PlannedRoad] = []
        self.junctions: list[Floats] = []
        self.cloud = np.zeros((0, 2))

    def add(self, points: Floats, width: float) -> None:
        self.roads.append(PlannedRoad(points, width))
        self.cloud = np.vstack([self.cloud, points])

    def grow(self) -> None:
        """Try one new street from a random place on a random road."""
        rng, style = self.rng, self.style
        chosen = self.roads[rng.integers(len(self.roads))]
        parent = chosen.points
        if len(parent) < 8 or chosen.manner == "apron":
            return
        index = int(rng.integers(3, len(parent) - 3))
        start = parent[index]
        if (start < 0).any() or (start > self.extent).any():
            return
        if any(np.hypot(*(start - place)) < 0.45 * style.spacing for place in self.junctions):
            return
        ahead = parent[index + 2] - parent[index - 2]
        side = rng.choice([-1, 1]) * np.pi / 2 + rng.normal(0, 0.12 if style.bend < 2e-3 else 0.3)
        points = self._reach(start, float(np.arctan2(ahead[1], ahead[0]) + side))
        if points is not None:
            self.junctions.append(start)
            self.add(points, rng.uniform(*style.widths))

    def _reach(self, start: Floats, heading: float) -> Floats | None:
        rng, style = self.rng, self.style
        points, curvature = [start], rng.normal(0, style.bend)
        limit = rng.uniform(0.5, 1.5) * style.length
        for count in range(1, int(limit / _STRIDE)):
            curvature += 0.25 * (rng.normal(0, style.bend) - curvature)
            heading += curvature * _STRIDE
            point = points[-1] + _STRIDE * np.array([np.cos(heading), np.sin(heading)])
            away = np.hypot(*(self.cloud - point).T)
            nearest = int(np.argmin(away))
            from_start = np.hypot(*(point - start))
            if from_start > 0.5 * style.spacing and away[nearest] < 0.42 * style.spacing:
                return self._meet(points, self.cloud[nearest])
            if from_start < 0.35 * count * _STRIDE or away[nearest] < 0.5 * from_start - 12:
                return None
            points.append(point)
            if (point < -25).any() or (point > self.extent + 25).any():
                return even(np.array(points), STEP)
        return self._end(np.array(points), heading)

    def _meet(self, points: list[Floats], target: Floats) -> Floats | None:
        kept = points[: max(2, len(points) - 2)]
        if np.hypot(*(kept[-1] - target)) < _STRIDE or len(kept) < 3:
            return None
        turn = _angle(kept[-1] - kept[-3], target - kept[-1])
        if turn > 1.3 or any(
            np.hypot(*(target - place)) < 0.3 * self.style.spacing for place in self.junctions
        ):
            return None
        self.junctions.append(target)
        return spline(
            np.vstack(
                [kept[::3], kept[-1:] if (len(kept) - 1) % 3 else np.zeros((0, 2)), target[None]]
            )
        )

    def _end(self, points: Floats, heading: float) -> Floats | None:
        if len(points) < 8:
            return None
        points = even(points, STEP)
        if self.rng.random() < self.style.turning_circles:
            radius = self.rng.uniform(5, 9)
            center = points[-1] + radius * np.array([np.cos(heading), np.sin(heading)])
            ring = arc(center, radius / 2, heading + np.pi, 2 * np.pi)
            self.roads.append(PlannedRoad(ring, radius, "apron", True))
            return even(np.vstack([points, center[None]]), STEP)
        return points


def _angle(a: Floats, b: Floats) -> float:
    cosine = float(a @ b) / max(1e-9, float(np.hypot(*a) * np.hypot(*b)))
    return float(np.arccos(np.clip(cosine, -1, 1)))


def grown(
    rng: np.random.Generator, extent: float, style: Style, roots: tuple[PlannedRoad, ...] = ()
) -> list[PlannedRoad]:
    """A network grown from `roots`, or from arterials of its own."""
    town = _Town(rng, extent, style)
    for root in roots:
        town.add(root.points, root.width)
    town.roads = list(roots)
    for _ in range(style.arterials):
        points = crossing(rng, extent, min(style.bend, 2.5e-3))
        town.add(points, rng.uniform(style.widths[1], style.widths[1] + 3))
    for _ in range(14 * style.streets):
        if len(town.roads) >= style.streets:
            break
        town.grow()
    return town.roads
