"""Loops over lines that numba compiles. Python never runs them; what they do to the last bit is
said in numpy elsewhere: `line_nodes.line_nodes`, `lines.line_table`."""

from __future__ import annotations

from typing import Any

import numpy as np


def line_nodes(
    begin: Any, points: Any, spacing: Any, closed: Any, directions: Any, out: Any
) -> None:  # fmt: skip
    """Fill `out`, (4, L, M), as `line_nodes.line_nodes`. `begin`: (L + 1,) where the `points`
    (5, P) of a line begin, arc lengths and what is at them; `spacing`: counts, pads, meters,
    lengths and turns; `directions`: (2, 2, L) cosines and sines of the headings at first and last
    points."""
    counts, pads, meters, length, turn = spacing
    s, slopes = points[0], np.empty(4)
    for i in range(counts.shape[0]):
        j, last, known = begin[i], begin[i + 1] - 1, -1
        used = counts[i] + 2 * pads[i]
        for m in range(used + 1):
            at, lap = (m - pads[i]) * meters[i], 0.0
            if closed[i]:
                lap = np.floor(at / length[i])
                at = at - lap * length[i]
            if at < s[j]:
                j = begin[i]
            while j < last and s[j + 1] <= at:
                j += 1
            if j != known:
                for k in range(4):
                    rise = points[k + 1, j + 1] - points[k + 1, j] if j < last else 0.0
                    slopes[k] = rise / (s[j + 1] - s[j]) if j < last else 0.0
                known = j
            rest = (s[begin[i]] if s[begin[i]] > at else at) - s[j]
            for k in range(4):
                there = points[k + 1, j]
                out[k, i, m] = slopes[k] * rest + there if rest != 0.0 else there
            if closed[i]:
                out[2, i, m] += lap * turn[i]
        if not closed[i]:
            for k in range(2):
                out[k, i, 0] += -meters[i] * directions[k, 0, i]
                out[k, i, used] += meters[i] * directions[k, 1, i]
        for k in range(4):
            for m in range(used + 1, out.shape[2]):
                out[k, i, m] = out[k, i, used]


def line_table(nodes: Any, spacing: Any, around: Any, out: Any) -> None:
    """Fill `out`, (L, M, 8), as `lines.line_table`. `nodes`: (4, L, M); `around`: (L,) cells to
    each side over which curvature is averaged."""
    x, y, heading, width = nodes
    last = x.shape[1] - 1
    for i in range(x.shape[0]):
        per_meter, over = 1.0 / spacing[i], 2.0 * around[i] * spacing[i]
        for m in range(last + 1):
            cell, after = out[i, m], min(m + 1, last)
            before, beyond = max(m - around[i], 0), min(m + around[i], last)
            cell[0], cell[1] = x[i, m], y[i, m]
            cell[2] = (x[i, after] - x[i, m]) * per_meter
            cell[3] = (y[i, after] - y[i, m]) * per_meter
            cell[4] = (heading[i, after] - heading[i, m]) / spacing[i]
            cell[5], cell[7] = heading[i, m], width[i, m]
            cell[6] = (heading[i, beyond] - heading[i, before]) / over
