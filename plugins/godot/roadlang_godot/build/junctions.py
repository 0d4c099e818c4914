"""Junctions without gaps or overlaps: each road is cut back, and a paved patch joins the ends."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats, triangulated

from ..net.protocol import Message
from ..net.scene_part import ScenePart
from .frame import SceneOrigin
from .line import RoadSamples

MARGIN = 1.5
"""How far beyond the point where two edges meet a road is cut, meters."""
LONGEST_SHARE = 0.45
"""Of a road's length, at each of its ends."""
_CORNER_STEPS = 6
_MOST_POINTS = 400


@dataclass(frozen=True, slots=True)
class RoadArm:
    """One road end at a node: the line, and whether it begins (+1) or ends (-1) there."""

    line: RoadSamples
    sign: int

    def station(self, cut: float) -> float:
        """Arc length at a distance from the node."""
        return float(self.line.s[0] + cut) if self.sign > 0 else float(self.line.s[-1] - cut)

    def outwards(self, cut: float = 0.0) -> tuple[Floats, Floats, float]:
        """Point, unit direction away from the node, and half width, at a distance from it."""
        points, heading, width = self.line.at(np.array([self.station(cut)]))
        direction = np.array([np.cos(heading[0]), np.sin(heading[0])]) * self.sign
        return points[0], direction, float(width[0] / 2)

    def corners(self, cut: float) -> tuple[Floats, Floats]:
        """Right and left corner of the cut, seen away from the node."""
        left, right = self.line.edges(np.array([self.station(cut)]))
        return (right[0], left[0]) if self.sign > 0 else (left[0], right[0])


def order(arms: list[RoadArm]) -> list[RoadArm]:
    """Arms counter-clockwise by the direction in which they leave."""

    def bearing(arm: RoadArm) -> float:
        _, direction, _ = arm.outwards(min(2.0, 0.2 * arm.line.length))
        return float(np.arctan2(direction[1], direction[0]))

    return sorted(arms, key=bearing)


def cuts(arms: list[RoadArm]) -> list[float]:
    """How far each arm (in order) is cut back, so that no two strips overlap."""
    count = len(arms)
    out = [MARGIN] * count
    looks = [arm.outwards(min(3.0, 0.2 * arm.line.length)) for arm in arms]
    for i in range(count):
        j = (i + 1) % count
        if i == j:
            continue
        (_, u, h), (_, v, k) = looks[i], looks[j]
        angle = float(np.arctan2(u[0] * v[1] - u[1] * v[0], u @ v)) % (2 * np.pi)
        if not 1e-3 < angle < np.pi - 1e-2:
            continue
        out[i] = max(out[i], (h * np.cos(angle) + k) / np.sin(angle) + MARGIN)
        out[j] = max(out[j], (k * np.cos(angle) + h) / np.sin(angle) + MARGIN)
    longest = [max(0.1, LONGEST_SHARE * arm.line.length) for arm in arms]
    return [min(cut, most, 40.0) for cut, most in zip(out, longest, strict=True)]


def area_patch(
    ring: Sequence[tuple[float, float]], id: int, frame: SceneOrigin, label: str, surface: int = 0
) -> ScenePart:
    """The area of a junction of the scene, a ring counter-clockwise; `surface`: its number."""
    points = np.array(ring)
    if len(points) > _MOST_POINTS:
        points = points[:: -(-len(points) // _MOST_POINTS)]
    corners = frame.ground(points)
    # Clockwise seen from above, which is the front in the engine.
    part = triangles_part(Message.PATCH, corners, triangulated(points)[:, ::-1], id, label)
    return replace(part, body=part.body + bytes([surface])) if surface else part


def patch(
    arms: list[RoadArm], cut: list[float], id: int, frame: SceneOrigin, label: str
) -> ScenePart:
    """The paved area between the cut ends of arms in order, with rounded corners."""
    outline: list[Floats] = []
    for i, arm in enumerate(arms):
        right, left = arm.corners(cut[i])
        outline += [right, left]
        j = (i + 1) % len(arms)
        if i != j:
            next_right, _ = arms[j].corners(cut[j])
            outline += _rounded(left, arm, cut[i], next_right, arms[j], cut[j])
    ring = np.array(outline)
    corners = frame.ground(np.vstack([ring.mean(axis=0), ring]))
    count = len(ring)
    spokes = np.arange(count)
    # Clockwise seen from above, which is the front in the engine.
    triangles = np.stack([np.zeros(count, int), (spokes + 1) % count + 1, spokes + 1], axis=-1)
    return triangles_part(Message.PATCH, corners, triangles, id, label)


def triangles_part(
    kind: Message, corners: Any, triangles: NDArray[np.int64], id: int, label: str
) -> ScenePart:
    """A flat shape: corners (n, 3) in the engine's coordinates, and which make a triangle."""
    head = struct.pack("<HH", len(corners), len(triangles))
    body = head + corners.tobytes() + triangles.astype("<u2").tobytes()
    content = corners.tobytes() + triangles.astype("<i4").tobytes()
    return ScenePart(kind, id, body, content, label)


def _rounded(
    start: Floats, arm: RoadArm, cut: float, end: Floats, other: RoadArm, other_cut: float
) -> list[Floats]:
    """Points of a curve from one cut's corner to the next one's, along both edges."""
    _, u, _ = arm.outwards(cut)
    _, v, _ = other.outwards(other_cut)
    cross = u[0] * v[1] - u[1] * v[0]
    if abs(cross) < 1e-2:
        return []
    gap = end - start
    along = (gap[0] * v[1] - gap[1] * v[0]) / cross
    width = float(np.hypot(*gap))
    if not -4 * width < along < 0:
        return []
    bend = start + u * along
    t = np.linspace(0, 1, _CORNER_STEPS + 1)[1:-1, None]
    return list((1 - t) ** 2 * start + 2 * t * (1 - t) * bend + t * t * end)
