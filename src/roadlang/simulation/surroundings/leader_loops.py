"""Who is next ahead in the lane, by two compiled loops: what `leaders` does in numpy, to the last
bit, on open lines and level ground. Sines and cosines in between are numpy's."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..lines import lines
from ..state.world import World
from ..vehicles import compiled, kernels
from ..vehicles.poses import Poses
from . import corridors, near_pairs
from .corridors import AHEAD, CIRCLES, MARGIN, SAMPLE_SPACING
from .near_pairs import MOST_VIEW, loop_over_pairs_near, view_at
from .outlines import Outlines

ROUNDING = 1e-6
"""Meters by which what is surely not in a corridor is farther away."""


@dataclass(frozen=True)
class Met:
    """What is in the corridors of agents: pairs (P,) of which some have infinite gaps, and (N,) who
    is next ahead of each."""

    agent: Integers
    target: Integers
    heading: Floats
    """(P,) of the lines where these are met"""
    least: Floats
    """(N,) gaps"""
    first: Integers
    """(N,) columns of whom they are to"""
    pair: Integers
    """(N,) which of the pairs that is, -1 for another"""


def can_search(world: World) -> bool:
    """Whether the loops are written for the lines of a world."""
    is_plain = not world.track.has_closed and not world.followed.guided
    return is_plain and world.heights is None and compiled.is_loaded()


def search(world: World, poses: Poses, pairs: Booleans, radius: Floats, gaps: Floats) -> Met:
    """Fill in the gaps (S, A, A) of those of the `pairs` of which the first has the second in its
    corridor. `radius`: (S, A) around agents."""
    track, bodies, count = world.track, world.bodies, len(world.present)
    speed, offset = world.motion.speed, world.followed.lateral.offset
    found, agents = np.empty((3, pairs.size), dtype=np.int64), np.empty(count, dtype=np.int64)
    frames = np.empty((5, samples_in(MOST_VIEW), count))  # numba takes long to return an array
    kept, most, columns = _windows()(
        pairs, radius, (poses.x, poses.y, speed, world.present),
        (world.motion.along, track.first, track.places, track.lines.table, offset),
        (world.sweeps.table, world.sweeps.left, world.sweeps.right),
        (bodies.length, bodies.width), (found, agents, frames),
    )  # fmt: skip
    heading, met = frames[2, :most, :columns], np.empty((3, kept))
    least, places = np.empty(count), np.empty((2, count), dtype=np.int64)
    outlines = Outlines.moving(world, poses).columns if kept else (least,) * 6
    _nearest()(
        (found, agents), (frames, (np.cos(heading), np.sin(heading))), outlines,
        (bodies.length, bodies.width, speed, offset), gaps, (met, least, places),
    )  # fmt: skip
    there = np.arctan2(met[2], met[1])
    return Met(found[0, :kept], found[1, :kept], there, least, places[0], places[1])


def loop_over_windows(
    pairs: Any, radius: Any, there: Any, lines_: Any, sweeps: Any, sizes: Any, out: Any
) -> Any:  # fmt: skip
    """Fill `out`: (3, at least P) agents, targets and columns of pairs of which the second may be
    in the corridor of the first; (at least I,) who is the first of any; and (5, at least M, at
    least I) x, y and heading of the reference lines that these have ahead, and what they cover
    there to their left and right beyond their widths. P, M and I. numba compiles it; Python never
    runs it."""
    (x, y, speed, _), (found, agents, frames) = there, out
    (table, left, right), (length, width) = sweeps, sizes
    count, groups = loop_over_pairs_near(pairs, radius, there, found, agents)
    most = 0
    for i in range(groups):
        most = max(most, samples_in(view_at(speed[agents[i]])))
    kept, columns, known = 0, 0, -1
    for p in range(count):
        agent, target = found[0, p], found[1, p]
        samples = samples_in(view_at(speed[agent]))
        if agent != known:  # as many columns as agents that keep a pair: others are written over
            known, taken, widest = agent, False, 0.0
            for k in range(5):
                for m in range(samples, most):
                    frames[k, m, columns] = 0.0
            for m in range(samples):
                cell = sampled(m, agent, lines_, frames, columns)
                frames[3, m, columns] = left[table[agent], cell]
                frames[4, m, columns] = right[table[agent], cell]
                widest = max(widest, frames[3, m, columns], frames[4, m, columns])
        bar = 0.5 * length[target] - 0.5 * width[target]
        reach = (bar if bar > 0.0 else 0.0) + corridor(width, agent, target) + SAMPLE_SPACING
        reach = reach + widest + abs(lines_[4][agent]) + ROUNDING
        least, place = np.inf, columns - 1 if taken else columns
        for m in range(samples):
            off_x, off_y = x[target] - frames[0, m, place], y[target] - frames[1, m, place]
            least = min(least, off_x * off_x + off_y * off_y)
        if least < reach * reach:
            if not taken:
                agents[columns], taken = agent, True
                columns += 1
            found[0, kept], found[1, kept], found[2, kept] = agent, target, columns - 1
            kept += 1
    return kept, most, columns


def sampled(m: Any, agent: Any, lines_: Any, frames: Any, column: Any) -> Any:
    """Put a sample of the line of an agent into `frames`. The cell of its line."""
    along, first, numbers, table, _ = lines_
    last, origin, spacing, per_meter = numbers[:, agent]
    advance, part = kernels.place_on_line(
        along[agent] + m * SAMPLE_SPACING, last, origin, per_meter
    )
    place = int(part)
    frames[0, m, column], frames[1, m, column], frames[2, m, column] = lines.on_arc(
        table[first[agent] + place], advance - place * spacing, spacing
    )
    return place


def samples_in(view: Any) -> Any:
    """How many samples of its line an agent looks at."""
    return int(view / SAMPLE_SPACING) + 1


def corridor(width: Any, agent: Any, target: Any) -> Any:
    """Half the width of the corridor of an agent for another."""
    return 0.5 * width[agent] + 0.5 * width[target] + MARGIN


def loop_over_nearest(
    pairs: Any, windows: Any, outlines: Any, agents: Any, gaps: Any, out: Any
) -> None:  # fmt: skip
    """Fill in the gaps (S, A, A) of pairs, and `out`, the last members of `Met`: (3, P) gaps and
    cosines and sines of lines, (N,) gaps and (2, N) columns and pairs. numba compiles it; Python
    never runs it."""
    (found, who), (frames, (cosine, sine)) = pairs, windows
    agent, target, column = found[0], found[1], found[2]
    (length, width, speed, offset), (met, least, places) = agents, out
    count, slots, (most, columns) = met.shape[1], gaps.shape[2], cosine.shape
    view, s = np.empty(columns), np.empty(most)
    for m in range(most):
        s[m] = m * SAMPLE_SPACING
    lines_ = np.empty((4, most, columns))
    for i in range(columns):
        view[i], aside = view_at(speed[who[i]]), offset[who[i]]
        for m in range(most):
            lines_[0, m, i] = frames[0, m, i] - sine[m, i] * aside
            lines_[1, m, i] = frames[1, m, i] + cosine[m, i] * aside
            lines_[2, m, i], lines_[3, m, i] = frames[3, m, i], frames[4, m, i]
    halves = np.empty((2, count))
    for p in range(count):
        halves[0, p] = corridor(width, agent[p], target[p])
        halves[1, p] = 0.5 * length[agent[p]]
    if count:
        x, y, toward_x, toward_y, half_length, half_width = outlines
        kernels.gaps_in_corridors(
            (column[:count], target[:count], halves[0], halves[1]),
            (lines_[0], lines_[1], cosine, sine), (lines_[2], lines_[3]), (s, view),
            (x, y, toward_x, toward_y, half_length, half_width),
            (CIRCLES, SAMPLE_SPACING, AHEAD), met,
        )  # fmt: skip
    for p in range(count):
        gaps[agent[p] // slots, agent[p] % slots, target[p] % slots] = met[0, p]
    for i in range(length.shape[0]):
        scene, first = i // slots, 0
        for k in range(1, slots):
            if gaps[scene, i % slots, k] < gaps[scene, i % slots, first]:
                first = k
        least[i] = gaps[scene, i % slots, first]
        places[0, i], places[1, i] = scene * slots + first, -1
    for p in range(count):
        if places[0, agent[p]] == target[p]:
            places[1, agent[p]] = p


@cache
def _windows() -> Any:
    loops = loop_over_pairs_near, sampled, samples_in, corridor, loop_over_windows
    compiled.register((view_at,), loops)
    return compiled.compile_loop(loop_over_windows, *_SAID)


@cache
def _nearest() -> Any:
    compiled.register((view_at,), (corridor, loop_over_nearest))
    return compiled.compile_loop(loop_over_nearest, *_SAID)


_SAID = sys.modules[__name__], corridors, near_pairs
