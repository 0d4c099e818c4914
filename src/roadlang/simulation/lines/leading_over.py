"""Lanes that end: the lines that lead from them over to the lanes beside them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...geometry.arrays import Booleans, Floats
from ...geometry.lanes.cross_section import CrossSection
from ..lanes.road_lanes import NARROW

FULL = 3.5
"""Meters: a lane that ends, and is narrower than this, leads over to the next lane."""
GONE = 0.1
"""Meters: a lane so narrow is not there."""
LEVEL = 1e-4
"""Meters by which the width of a lane changes from node to node, at least, where it begins or
ends."""
EARLY = 1.0 / 3.0
"""Share of the length of a taper by which lines begin to lead over before it: long vehicles need
more room for that than the taper has."""


def led_over(section: CrossSection, middles: Floats, stations: Floats) -> Floats:
    """(L, nodes) the middles of lanes; of those that end, over to the next lane, and if that ends
    as well on to the one after it."""
    widths = np.array(
        [np.broadcast_to(section.lane_width(id, stations), len(stations)) for id in section.ids]
    )
    most, least = widths.max(axis=1), widths.min(axis=1)
    open_ = [lane.drivable and most[row] >= NARROW for row, lane in enumerate(section.lanes)]
    ends = [drives and least[row] < NARROW for row, drives in enumerate(open_)]
    out = middles.copy()
    steps = {row: _next_lane(section, row, open_, ends) for row in np.flatnonzero(ends).tolist()}
    # Who is nearest to a lane that goes on comes first: others lead over to where it leads.
    for row, (far, side) in sorted(steps.items(), key=lambda item: item[1][0]):
        if far:
            # The middle of the lane if it kept its width, beside the lane that it leads over to.
            share, full = _over(widths[row])
            middle = middles[row] + side * 0.5 * (full - widths[row])
            out[row] = middle + share * (out[row + side] - middle)
    return out


def _over(width: Floats) -> tuple[Floats, Floats]:
    """(nodes,) the share of the way over to the next lane, and the width of the lane before it
    began to end; for a lane of these widths."""
    gone = width < GONE
    if not gone.any():
        missing = np.clip(1.0 - width / min(FULL, float(width.max())), 0.0, 1.0)
        return missing * missing * (3.0 - 2.0 * missing), width.max() + 0.0 * width
    share, full = gone.astype(float), width.copy()
    for edge in np.flatnonzero(gone[1:] != gone[:-1]).tolist():
        step = -1 if gone[edge + 1] else 1
        stop = edge + 1 if step < 0 else edge  # the first node without the lane
        wider = np.diff(width[stop::step])
        count = _run(wider > LEVEL)
        level = _run(np.abs(wider[count:]) <= LEVEL)
        early = min(round(EARLY * count), level // 2)
        done = 1.0 - np.arange(count + early + 1) / max(count + early, 1)
        node = stop + step * np.arange(count + early + 1)
        share[node] = done**3 * (10.0 - 15.0 * done + 6.0 * done * done)
        full[node[: count + 1]] = width[stop + step * count]
    return share, full


def _run(true: Booleans) -> int:
    """How many are true, from the first on."""
    return int(true.argmin()) if not true.all() else len(true)


def _next_lane(
    section: CrossSection, row: int, open_: Sequence[bool], ends: Sequence[bool]
) -> tuple[int, int]:
    """How many lanes away from one that ends the nearest lane of its direction is that goes on, and
    on which side; zeros for none. Of two as near, the one toward the middle of the road."""
    inward = 1 if section.ids[row] > 0 else -1
    for far in range(1, len(ends)):
        for side in (inward, -inward):
            between = range(row + side, row + side * (far + 1), side)
            fits = 0 <= between[-1] < len(ends) and not ends[between[-1]]
            if fits and all(open_[k] and _same_way(section, row, k) for k in between):
                return far, side
    return 0, 0


def _same_way(section: CrossSection, one: int, other: int) -> bool:
    return section.lanes[one].direction == section.lanes[other].direction
