"""Edge lines along the curbs of junctions, from road to road."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
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
        for corner in corners(junction):
            if (
                marked[corner.first.road][corner.border]
                and marked[corner.last.road][corner.next_border]
            ):
                yield from _ribbon(corner.curb)


@dataclass(frozen=True, slots=True, eq=False)
class CurbCorner:
    """The curb from one road of a junction to the next, counter-clockwise."""

    first: SceneArm
    last: SceneArm
    curb: Floats
    """(n, 2), with the junction on its left"""

    @property
    def border(self) -> int:
        """Which border of the first road it goes on: 0 the left one, 1 the right one."""
        return 0 if self.first.end == "start" else 1

    @property
    def next_border(self) -> int:
        """Which border of the last road it leads to."""
        return 1 if self.last.end == "start" else 0


def corners(junction: SceneJunction) -> Iterator[CurbCorner]:
    """The corners of a junction whose curbs have a length."""
    area = np.array(junction.area, dtype=float)
    for arm in junction.arms:
        last = min(junction.arms, key=lambda other: (other.right - arm.left) % len(area))
        count = (last.right - arm.left) % len(area) + 1
        curb = area[(arm.left + np.arange(count)) % len(area)]
        steps = np.hypot(*np.diff(curb, axis=0).T)
        curb = curb[np.concatenate([[True], steps > _LEAST_STEP])]
        if len(curb) > 1:
            yield CurbCorner(arm, last, curb)


def beside(curb: Floats, away: Floats) -> Floats:
    """(n, 2) the line `away` (n,) meters left of a curb (n, 2), its corners mitered."""
    along = np.diff(curb, axis=0)
    along /= np.hypot(*along.T)[:, None]
    normals = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    before, after = np.vstack([normals[:1], normals]), np.vstack([normals, normals[-1:]])
    # To the corner of the two borders; at most as far as where they turn by 120 degrees.
    miters = (before + after) / np.maximum(1.0 + (before * after).sum(axis=1), 0.5)[:, None]
    return np.asarray(curb + away[:, None] * miters)


def _marked_borders(section: CrossSection | None) -> tuple[bool, bool]:
    """Whether a road has an edge line along its left and right border."""
    if section is None:
        return (True, True)
    lanes, markings = section.lanes, section.markings
    left, right = (lanes[end].drivable and markings[end] == "solid" for end in (0, -1))
    return left, right


def _ribbon(curb: Floats) -> Iterator[Floats]:
    """Pieces of the line inside a curb."""
    ones = np.ones(len(curb))
    outer, inner = (
        beside(curb, (INSET - 0.5 * WIDTH) * ones),
        beside(curb, (INSET + 0.5 * WIDTH) * ones),
    )
    for i in range(len(curb) - 1):
        yield np.array([outer[i], outer[i + 1], inner[i + 1], inner[i]])
