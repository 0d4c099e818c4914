"""Edge lines along the curbs of junctions, from road to road."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import CrossSection, Floats

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneArm, SceneJunction

INSET = 0.25
"""Meters from the curb to the middle of the line, as along roads (`shaders/road.gdshader`)."""
WIDTH = 0.14
_LEAST_STEP = 1e-3


def edge_line_rings(scene: Scene, junctions: Iterable[SceneJunction]) -> Iterator[Floats]:
    """Quadrilaterals (4, 2), counter-clockwise, one for each straight piece of a line.

    Where both roads beside a corner have edge lines, these are joined around the corner: at the
    mouth of a T, along the side that goes straight on, too.
    """
    marked = {road.name: _marked_borders(road.cross_section()) for road in scene.roads}
    for junction in junctions:
        area = np.array(junction.area, dtype=float)
        arms = sorted(junction.arms, key=lambda arm: arm.left)
        for arm in arms:
            other = _next(arm, arms, len(area))
            if _has_line(arm, marked, left=True) and _has_line(other, marked, left=False):
                count = (other.right - arm.left) % len(area) + 1
                yield from _ribbon(area[(arm.left + np.arange(count)) % len(area)])


def _next(arm: SceneArm, arms: list[SceneArm], count: int) -> SceneArm:
    """The arm at the other end of the curb that begins at the left of this one."""
    return min(arms, key=lambda other: (other.right - arm.left) % count)


def _marked_borders(section: CrossSection | None) -> tuple[bool, bool]:
    """Whether a road has an edge line along its left and right border."""
    if section is None:
        return (True, True)
    lanes, markings = section.lanes, section.markings
    left, right = (lanes[end].drivable and markings[end] == "solid" for end in (0, -1))
    return left, right


def _has_line(arm: SceneArm, marked: dict[str, tuple[bool, bool]], left: bool) -> bool:
    """`left`: as seen from inside the junction."""
    is_roads_left = left == (arm.end == "start")
    return marked[arm.road][0 if is_roads_left else 1]


def _ribbon(curb: Floats) -> Iterator[Floats]:
    """Pieces of the line inside a curb whose inside is on its left."""
    steps = np.hypot(*np.diff(curb, axis=0).T)
    curb = curb[np.concatenate([[True], steps > _LEAST_STEP])]
    if len(curb) < 2:
        return
    along = np.diff(curb, axis=0)
    along /= np.hypot(*along.T)[:, None]
    normals = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    before, after = np.vstack([normals[:1], normals]), np.vstack([normals, normals[-1:]])
    # To the corner of the two borders; at most as far as where they turn by 120 degrees.
    miters = (before + after) / np.maximum(1.0 + (before * after).sum(axis=1), 0.5)[:, None]
    outer = curb + (INSET - 0.5 * WIDTH) * miters
    inner = curb + (INSET + 0.5 * WIDTH) * miters
    for i in range(len(curb) - 1):
        yield np.array([outer[i], outer[i + 1], inner[i + 1], inner[i]])
