"""Who meets whom in narrow places, by compiled loops: what `narrow_places` gives of the ways of
all agents, to the last bit, on open lines and level ground. Sines and cosines in between are
numpy's."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...geometry.curves import bend_room
from ...geometry.curves.bend_room import LONG, PASSING_GAP
from ..lines import lines
from ..state.world import World
from ..vehicles import compiled, kernels
from ..vehicles.poses import Poses
from . import narrow_places, sampled_ways, wide_places
from .narrow_places import come_close, loop_over_ways
from .sampled_ways import SPACING
from .wide_places import LEAST_SWEPT, ROUNDING, VIEW, WidePlaces


def is_plain(world: World) -> bool:
    """Whether the loops are written for the lines of a world."""
    has_plain_lines = not world.track.has_closed and not world.followed.guided
    return has_plain_lines and world.heights is None and compiled.is_loaded()


def meeting_places(
    world: World, poses: Poses, wide: WidePlaces
) -> tuple[Integers, Integers, Floats, Floats] | None:
    """(P,) and (P,) the agents of pairs, and what `narrow_places` gives of them; None where there
    is no such place."""
    bodies, track, count = world.bodies, world.track, len(world.present)
    agents, slots, sweeps = np.empty(count, dtype=np.int64), world.slots, world.sweeps
    who = (world.present, world.has_road, bodies.walks, world.has_route)
    lines_ = (world.motion.along, world.end, track.first, track.places, track.lines.table)
    found, samples = _wide()(
        who, bodies.length, lines_, (sweeps.table, wide.counts), slots, agents
    )  # fmt: skip
    if not found:
        return None
    ways, is_wide = np.empty((6, samples, found)), np.empty((samples, found), dtype=bool)
    _ways()(
        who, (bodies.length, bodies.width), lines_, (sweeps.table, sweeps.left, sweeps.right),
        agents, ways, is_wide,
    )  # fmt: skip
    turned = np.cos(ways[3]), np.sin(ways[3])
    pairs, ends = np.empty((2, found * slots), dtype=np.int64), np.empty(8 * found * slots)
    met = _meetings()(
        agents, ways, turned, is_wide, world.followed.lateral.offset, (poses.x, poses.y), slots,
        (pairs, ends),
    )  # fmt: skip
    if not met:
        return None
    enter, leave = ends[: 8 * met].reshape(2, 2, 2 * met)
    return pairs[0, :met], pairs[1, :met], enter, leave


def loop_over_wide(
    flags: Any, length: Any, track: Any, places: Any, slots: Any, agents: Any
) -> Any:  # fmt: skip
    """Fill `agents`, (at least I,), with all that move in scenes where anybody may come to a wide
    place. I, and how many samples of their ways there are. numba compiles it; Python never runs
    it."""
    (present, has_road, walks, _), along, (table, counts) = flags, track[0], places
    count, longest = 0, 0.0
    for scene in range(present.shape[0] // slots):
        before, comes = count, False
        for i in range(scene * slots, (scene + 1) * slots):
            if present[i] and has_road[i] and not walks[i]:
                agents[count] = i
                count += 1
                around = 0.5 * length[i] + ROUNDING
                first = cell_at(track, i, along[i] - around)
                last = cell_at(track, i, along[i] + around + VIEW) + 1
                comes = comes or counts[table[i], last] > counts[table[i], first]
        count = count if comes else before
    for k in range(count):
        longest = max(longest, 0.5 * length[agents[k]])
    return count, int(np.ceil((VIEW + 2.0 * longest) / SPACING)) + 1


def loop_over_samples(
    flags: Any, sizes: Any, track: Any, sweeps: Any, agents: Any, ways: Any, is_wide: Any
) -> None:  # fmt: skip
    """Fill `ways`, (6, M, I), with the members `s`, `x`, `y`, the heading, `to_left` and `to_right`
    of `SampledWays`, without what their lines are moved by, and `is_wide`, (M, I). numba compiles
    it; Python never runs it."""
    for k in range(ways.shape[2]):
        for m in range(ways.shape[1]):
            sample(flags, sizes, track, sweeps, (agents[k], k, m), ways, is_wide)


def cell_at(track: Any, i: Any, along: Any) -> Any:
    """The cell of the line of an agent at an arc length."""
    last, origin, _, per_meter = track[3][:, i]
    return int(kernels.place_on_line(along, last, origin, per_meter)[1])


def sample(
    flags: Any, sizes: Any, track: Any, sweeps: Any, which: Any, ways: Any, is_wide: Any
) -> None:  # fmt: skip
    """One sample of the way of an agent."""
    (i, k, m), (table, left, right), (length, width) = which, sweeps, sizes
    along, end, first, numbers, cells = track
    half, beside = 0.5 * length[i], 0.5 * width[i]
    s = m * SPACING - half
    last, origin, spacing, per_meter = numbers[:, i]
    there = along[i] + s
    advance, part = kernels.place_on_line(there, last, origin, per_meter)
    place = int(part)
    cell = cells[first[i] + place]
    x, y, heading = lines.on_arc(cell, advance - place * spacing, spacing)
    to_left, to_right = left[table[i], place], right[table[i], place]
    over = there > end[i] + half or s > VIEW + half
    ways[0, m, k] = np.nan if over else s
    ways[1, m, k], ways[2, m, k], ways[3, m, k] = x, y, heading
    ways[4, m, k], ways[5, m, k] = to_left + beside, to_right + beside
    in_lane = flags[3][i] and length[i] <= LONG
    spare = 0.5 * cell[7] - beside - 0.5 * PASSING_GAP if in_lane else 0.0
    is_wide[m, k] = max(to_left, to_right) > max(spare, LEAST_SWEPT) and not over


def loop_over_pairs(
    agents: Any, ways: Any, turned: Any, is_wide: Any, offset: Any, there: Any, slots: Any,
    out: Any,
) -> Any:  # fmt: skip
    """Fill `out`: (2, at least P) the agents of pairs and, at the beginning of the other, what
    `narrow_places` gives of them, (2, 2, 2 P). P, 0 where there is no such place. numba compiles
    it; Python never runs it."""
    (cosine, sine), samples, count = turned, ways.shape[1], ways.shape[2]
    ends, bends = np.empty((count, 4)), np.zeros(count, np.bool_)
    for k in range(count):
        ends[k, 0], ends[k, 1], ends[k, 2], ends[k, 3] = np.inf, np.inf, -np.inf, -np.inf
        for m in range(samples):
            ways[1, m, k] -= sine[m, k] * offset[agents[k]]
            ways[2, m, k] += cosine[m, k] * offset[agents[k]]
            if is_wide[m, k]:
                bends[k] = True
                for axis in range(2):
                    ends[k, axis] = min(ends[k, axis], ways[1 + axis, m, k])
                    ends[k, 2 + axis] = max(ends[k, 2 + axis], ways[1 + axis, m, k])
    found, pairs = np.empty((2, count * slots), np.int64), 0
    for k in range(count):
        for other in range(max(0, k - slots), min(count, k + slots)):
            mates = agents[other] // slots == agents[k] // slots and other != k
            if bends[k] and mates and (k < other or not bends[other]):
                x, y = there[0][agents[other]], there[1][agents[other]]
                if max(ends[k, 0] - x, x - ends[k, 2], ends[k, 1] - y, y - ends[k, 3]) < VIEW:
                    found[0, pairs], found[1, pairs] = k, other
                    pairs += 1
    first, second = found[0, :pairs], found[1, :pairs]
    lines_ = ways[1], ways[2], cosine, sine, ways[4], ways[5]
    places = out[1][: 8 * pairs].reshape((2, 2, 2 * pairs))
    is_any = loop_over_ways(ways[0], lines_, first, second, places)
    for p in range(pairs):
        out[0][0, p], out[0][1, p] = agents[first[p]], agents[second[p]]
    return pairs if is_any else 0


@cache
def _wide() -> Any:
    compiled.register((), (cell_at, loop_over_wide))
    return compiled.compile_loop(loop_over_wide, *_SAID)


@cache
def _ways() -> Any:
    compiled.register((), (sample, loop_over_samples))
    return compiled.compile_loop(loop_over_samples, *_SAID)


@cache
def _meetings() -> Any:
    compiled.register((), (loop_over_ways, come_close, loop_over_pairs))
    return compiled.compile_loop(loop_over_pairs, *_SAID)


_SAID = sys.modules[__name__], narrow_places, sampled_ways, wide_places, bend_room
