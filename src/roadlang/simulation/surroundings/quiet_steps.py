"""Steps in which nobody comes near anybody: told by a compiled loop, without exact poses."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..lines import lines
from ..vehicles import kernels

MARGIN = 1e-3
"""Meters by which places and ways may be off: the sine is not numpy's."""


def loop_over_places(
    motion: Any, track: Any, before: Any, contact: Any, flags: Any, found: Any
) -> Any:  # fmt: skip
    """Fill `found`, (2, N), with where agents are, within `MARGIN`. How far whoever went farthest
    has come since they were at `before`, (2, N); -1 where a pair may have met in between.
    `contact`: pairs, and of agents radii, half lengths and half widths. numba compiles it; Python
    never runs it."""
    (along, offset, heading, cosine, sine), (first, numbers, table) = motion, track
    (one, other), radius, _, _ = contact
    present, halted = flags
    way, farthest = np.empty((3, radius.shape[0])), 0.0
    for i in range(radius.shape[0]):
        last, origin, spacing, per_meter = numbers[:, i]
        advance, part = kernels.place_on_line(along[i], last, origin, per_meter)
        rest = advance - int(part) * spacing
        x, y, _ = lines.on_arc(table[first[i] + int(part)], rest, spacing)
        toward_x, toward_y = np.cos(heading[i]), np.sin(heading[i])
        found[0, i], found[1, i] = x - toward_y * offset[i], y + toward_x * offset[i]
        off_x, off_y = found[0, i] - before[0, i], found[1, i] - before[1, i]
        way[0, i] = np.sqrt(off_x * off_x + off_y * off_y) + MARGIN
        way[1, i] = toward_x * cosine[i] - toward_y * sine[i]
        way[2, i] = toward_y * cosine[i] + toward_x * sine[i]
        farthest = way[0, i] if way[0, i] > farthest else farthest
    for p in range(one.shape[0]):
        i, j = one[p], other[p]
        off_x, off_y = found[0, i] - found[0, j], found[1, i] - found[1, j]
        gone = way[0, i] + way[0, j] + MARGIN
        reach = radius[i] + radius[j] + gone
        are_far = off_x * off_x + off_y * off_y > reach * reach
        counts = present[i] and present[j] and not (halted[i] and halted[j])
        # What is no number is looked at more closely.
        may_meet = counts and not are_far
        if may_meet and not are_apart(way, contact, (i, j), (off_x, off_y), gone):
            return -1.0
    return farthest


def are_apart(way: Any, contact: Any, pair: Any, off: Any, gone: Any) -> Any:
    """Whether the sides of one of two footprints show that these have not met on ways that are
    together no longer than `gone`. `way`: cosine and sine of headings in its last two rows."""
    (i, j), (_, _, half_length, half_width) = pair, contact
    cosine = abs(way[1, i] * way[1, j] + way[2, i] * way[2, j])
    sine = abs(way[1, i] * way[2, j] - way[2, i] * way[1, j])
    for a, b in ((i, j), (j, i)):
        ahead = abs(off[0] * way[1, a] + off[1] * way[2, a])
        beside = abs(off[0] * way[2, a] - off[1] * way[1, a])
        if ahead > half_length[a] + half_length[b] * cosine + half_width[b] * sine + gone:
            return True
        if beside > half_width[a] + half_length[b] * sine + half_width[b] * cosine + gone:
            return True
    return False
