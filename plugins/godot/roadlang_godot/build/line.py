"""A center line with width, to be sampled anywhere: cubic Hermite between a scene's samples."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import geometry, route_points, surface_stretches
from roadlang.geometry import Floats

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad, SceneRoute, SurfaceStretch


@dataclass(frozen=True)
class RoadSamples:
    """Samples of a road: `s` (n,) arc length, `points` (n, 2), `heading` (n,), `width` (n,).

    A closed line has its first sample again at the end. `section` are its lanes by `s`; without
    it `lanes` share the width. `stretches`: the surfaces of its lanes along it, where any is said.
    """

    name: str
    s: Floats
    points: Floats
    heading: Floats
    width: Floats
    lanes: int
    closed: bool
    section: geometry.CrossSection | None = None
    stretches: tuple[SurfaceStretch, ...] = ()

    @cached_property
    def cross_section(self) -> geometry.CrossSection:
        """The lanes by arc length."""
        if self.section is not None:
            return self.section
        return geometry.CrossSection.of_lane_count(
            max(self.lanes, 1), geometry.WidthProfile(self.s, self.width)
        )

    @cached_property
    def length(self) -> float:
        """Arc length from the first to the last sample, in meters."""
        return float(self.s[-1] - self.s[0])

    @cached_property
    def curvature(self) -> Floats:
        """(n,) 1/m, by differences."""
        return np.gradient(np.unwrap(self.heading), self.s)

    def at(self, s: Floats) -> tuple[Floats, Floats, Floats]:
        """Points (m, 2), headings (m,) and widths (m,) at arc lengths `s` (m,)."""
        i = np.clip(np.searchsorted(self.s, s, side="right") - 1, 0, len(self.s) - 2)
        step = self.s[i + 1] - self.s[i]
        t = ((s - self.s[i]) / step)[:, None]
        tangent = np.stack([np.cos(self.heading), np.sin(self.heading)], axis=-1)
        a, b = self.points[i], self.points[i + 1]
        m, n = tangent[i] * step[:, None], tangent[i + 1] * step[:, None]
        points = (
            (1 + 2 * t) * (1 - t) ** 2 * a
            + t * (1 - t) ** 2 * m
            + t * t * (3 - 2 * t) * b
            + t * t * (t - 1) * n
        )
        slope = 6 * t * (t - 1) * (a - b) + (1 - t) * (1 - 3 * t) * m + t * (3 * t - 2) * n
        heading = np.arctan2(slope[:, 1], slope[:, 0])
        return points, heading, np.interp(s, self.s, self.width)

    def edges(self, s: Floats) -> tuple[Floats, Floats]:
        """Left and right edge (m, 2) of the drivable lanes at arc lengths `s` (m,)."""
        left, right = self.beside(s, np.stack(self.cross_section.drivable_extent(s)))
        return left, right

    def beside(self, s: Floats, offsets: Floats) -> Floats:
        """Points (k, m, 2) at lateral offsets (k, m), left positive."""
        points, heading, _ = self.at(s)
        left = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
        return np.asarray(points + offsets[..., None] * left)


def line_of(road: SceneRoad) -> RoadSamples:
    """The line of a scene's road."""
    s = np.asarray(road.stations, dtype=float)
    points = np.stack([np.asarray(road.x, dtype=float), np.asarray(road.y, dtype=float)], axis=-1)
    heading = np.asarray(road.heading, dtype=float)
    width = np.asarray(road.width, dtype=float)
    if road.closed and np.hypot(*(points[0] - points[-1])) > 1e-6:
        s = np.append(s, max(road.length, s[-1] + float(np.hypot(*(points[0] - points[-1])))))
        points = np.vstack([points, points[:1]])
        heading = np.append(heading, heading[0])
        width = np.append(width, width[0])
    section = road.cross_section()
    said = road.surface is not None or road.surface_patches
    stretches = surface_stretches(road, section.ids) if said else ()
    return RoadSamples(
        road.name, s, points, heading, width, road.lanes, road.closed, section, stretches
    )


def line_of_route(name: str, scene: Scene, route: SceneRoute) -> RoadSamples:
    """The line of a route, one lane wide."""
    x, y, heading, width = route_points(scene, route)
    points = np.stack([x, y], axis=-1)
    steps = np.hypot(*np.diff(points, axis=0).T)
    s = np.concatenate([[0.0], np.cumsum(steps)])
    return RoadSamples(name, s, points, heading, np.array(width), 1, route.closed)


def polyline(
    name: str, points: Floats, width: float, lanes: int = 2, closed: bool = False
) -> RoadSamples:
    """The line through (n, 2) points; headings are those of the chords on both sides."""
    points = np.asarray(points, dtype=float)
    if closed:
        points = np.vstack([points, points[:1]])
    steps = np.hypot(*np.diff(points, axis=0).T)
    s = np.concatenate([[0.0], np.cumsum(steps)])
    ahead = np.gradient(points, s, axis=0)
    if closed:
        ahead[0] = ahead[-1] = (points[1] - points[-2]) / (steps[0] + steps[-1])
    heading = np.arctan2(ahead[:, 1], ahead[:, 0])
    return RoadSamples(name, s, points, heading, np.full(len(s), float(width)), lanes, closed)
