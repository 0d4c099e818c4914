"""The curbs of junctions from road to road, and the edge lines along them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from ..geometry import CrossSection
from ..geometry.arrays import Floats
from ..geometry.lanes.lane_paint import EDGE_INSET
from ..ir.scene_junctions import SceneArm, SceneJunction
from ..ir.scene_road import SceneRoad

_LEAST_STEP = 1e-3


def edge_lines(junction: SceneJunction, roads: Mapping[str, SceneRoad]) -> Iterator[Floats]:
    """(n, 2) the middles of solid lines.

    Where both roads beside a corner have edge lines, these are joined around the corner: at the
    mouth of a T, along the side that goes straight on, too.
    """
    for corner in junction_curbs(junction):
        ends = (corner.first, corner.border), (corner.last, corner.next_border)
        if all(_is_marked(roads[arm.road].cross_section(), border) for arm, border in ends):
            yield beside_curb(corner.curb, np.full(len(corner.curb), EDGE_INSET))


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


def junction_curbs(junction: SceneJunction) -> Iterator[CurbCorner]:
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


def beside_curb(curb: Floats, away: Floats) -> Floats:
    """(n, 2) the line `away` (n,) meters left of a curb (n, 2), its corners mitered."""
    along = np.diff(curb, axis=0)
    along /= np.hypot(*along.T)[:, None]
    normals = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    before, after = np.vstack([normals[:1], normals]), np.vstack([normals, normals[-1:]])
    # To the corner of the two borders; at most as far as where they turn by 120 degrees.
    miters = (before + after) / np.maximum(1.0 + (before * after).sum(axis=1), 0.5)[:, None]
    return np.asarray(curb + away[:, None] * miters)


def _is_marked(section: CrossSection | None, border: int) -> bool:
    """Whether a road has an edge line along its left (0) or right (1) border."""
    if section is None:
        return True
    end = -border
    return section.lanes[end].drivable and section.markings[end] == "solid"
