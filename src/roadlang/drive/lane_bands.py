"""The surfaces of a road between junctions: its roadway, and the lanes beside and in it that look
different, as figures of drives and reports draw them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.lanes.cross_section import drivable_borders
from ..scenes.figure_colors import FIGURE_COLORS
from .lane_lines import TOLERANCE, ShownPart, with_few_points


@dataclass(frozen=True, eq=False)
class LaneBand:
    """The surface between two lines (n, 2) along a road."""

    left: Floats
    right: Floats
    is_driven: bool = True
    raised: bool = False
    """behind a curb"""
    inner: bool = False
    """between drivable lanes"""
    cover: str | None = None
    """the color of what lies on a lane that is not asphalt"""

    @property
    def ring(self) -> Floats:
        """(n, 2) around it."""
        return np.concatenate([self.left, self.right[::-1]])


def lane_bands(part: ShownPart) -> Iterator[LaneBand]:
    """The roadway, with what lies between its lanes, and each lane that nobody drives on."""
    drivable = np.array([lane.drivable for lane in part.section.lanes])
    first, last = drivable_borders(drivable)
    yield LaneBand(part.beside(part.borders[first]), part.beside(part.borders[last]))
    for place in np.flatnonzero(~drivable).tolist():
        left, right = (part.beside(part.borders[place + side]) for side in (0, 1))
        raised = part.section.lanes[place].raised
        yield LaneBand(left, right, False, raised, first <= place < last)
    yield from _covers(part)


def _covers(part: ShownPart) -> Iterator[LaneBand]:
    """Of each lane and stretch of another surface than asphalt."""
    for stretch in part.stretches:
        there = (part.stations >= stretch.start) & (part.stations <= stretch.end)
        for place, (lane, name) in enumerate(
            zip(part.section.lanes, stretch.surfaces, strict=True)
        ):
            color = FIGURE_COLORS.of_surface(name)
            if color is None or lane.raised or there.sum() < 2:
                continue
            left, right = (part.beside(part.borders[place + side])[there] for side in (0, 1))
            yield LaneBand(left, right, lane.drivable, cover=color)


def bands_and_lines(
    bands: Sequence[LaneBand], lines: Sequence[Floats], tolerance: float = TOLERANCE
) -> tuple[list[LaneBand], list[Floats]]:
    """Bands and lines (n, 2) with few points that look the same; all together take little more
    time than some of them."""
    sides = [side for band in bands for side in (band.left, band.right)]
    thin = iter(with_few_points([*sides, *lines], tolerance))
    return [replace(band, left=next(thin), right=next(thin)) for band in bands], list(thin)
