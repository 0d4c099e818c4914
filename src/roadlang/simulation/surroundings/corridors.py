"""What stands in the way along the lines that agents follow, wherever it comes from.

The line ahead of an agent is sampled; whatever is close enough to a sample lies in the corridor of
the agent. Roads and lanes play no part in this, so that those on other roads, on connections that
part or join, half on the lane before, or on no road at all are found alike.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles import compiled
from ..vehicles.poses import frames_ahead
from .levels import apart_where_met, ground_heights
from .near_pairs import PairsAhead, looks_ahead
from .outlines import Outlines

SAMPLE_SPACING = 2.0
"""Meters along the line."""
CIRCLES = 5
"""A footprint is as wide circles in a row as these, from its front to its rear."""
MARGIN = 0.2
"""Meters to each side between two that pass each other."""
AHEAD = 0.5
"""Meters behind the front bumper, at most, from which on something is ahead."""


@dataclass(frozen=True)
class Window:
    """The lines ahead of some agents I, sampled at M places: arrays (M, I)."""

    agents: Integers
    s: Floats
    """(M,) meters ahead of the agents"""
    view: Floats
    """(I,) how far each looks"""
    x: Floats
    y: Floats
    cosine: Floats
    sine: Floats
    swept: tuple[Floats, Floats]
    """meters that the agent covers there beyond its width, to its left and right"""

    @classmethod
    def of(cls, world: World, agents: Integers) -> Window:
        """What these agents have ahead."""
        rows: Any = slice(None) if len(agents) == len(world.present) else agents
        view = looks_ahead(world)[rows]
        count = math.ceil(float(view.max(initial=0.0)) / SAMPLE_SPACING) + 1
        s: Floats = np.arange(count, dtype=np.float64) * SAMPLE_SPACING
        track = world.track.of_rows(rows)
        along = track.wrapped(world.motion.along[rows] + s[:, None])
        cell, (x, y, heading, _, _) = frames_ahead(track, along)
        cosine, sine = np.cos(heading), np.sin(heading)
        offset = world.followed.offset(rows, along)
        x, y = x - sine * offset, y + cosine * offset
        swept = world.sweeps.at(rows, cell - track.first)
        return cls(agents, s, view, x, y, cosine, sine, swept)


def nearest_in_corridor(
    world: World, pairs: PairsAhead, outlines: Outlines
) -> tuple[Floats, Floats]:
    """(P,) of pairs: the gap along the line to what
    of it is in the corridor, infinite where nothing is, and the heading of the line there. Who is
    on another level than the line there is not in the corridor.
    """
    agent, target = pairs.agent, pairs.target
    gap, heading = _nearest(world, pairs, outlines)
    if world.heights is not None:
        apart = apart_where_met(
            world, agent, gap + 0.5 * world.bodies.length[agent], ground_heights(world)[target]
        )
        gap = np.where(apart, math.inf, gap)
    return gap, heading


def _nearest(world: World, pairs: PairsAhead, outlines: Outlines) -> tuple[Floats, Floats]:
    agent, target, column = pairs.agent, pairs.target, pairs.column
    if not len(agent):
        return np.zeros(0), np.zeros(0)
    window = Window.of(world, pairs.agents)
    half = 0.5 * world.bodies.width[agent] + outlines.half_width[target] + MARGIN
    if compiled.is_loaded():
        of_pairs = (column, target, half, 0.5 * world.bodies.length[agent])
        limits = CIRCLES, SAMPLE_SPACING, AHEAD
        gap, cosine, sine = compiled.gaps_in_corridors(of_pairs, window, outlines, limits)
        return gap, np.arctan2(sine, cosine)
    gap, heading = np.full(len(agent), math.inf), np.zeros(len(agent))
    close = np.flatnonzero(_may_overlap(window, column, target, outlines, half))
    if not len(close):
        return gap, heading
    half_length = 0.5 * world.bodies.length[agent[close]]
    found = _circles(window, column[close], outlines.take(target[close]), half[close], half_length)
    gap[close], heading[close] = found
    return gap, heading


def _may_overlap(
    window: Window, column: Integers, target: Integers, outlines: Outlines, half: Floats
) -> Booleans:
    """(P,) whether any part can lie in the corridor."""
    off_x = outlines.x[target] - window.x[:, column]
    off_y = outlines.y[target] - window.y[:, column]
    square = off_x * off_x + off_y * off_y
    seen = window.s[:, None] <= window.view[column]
    swept = np.maximum(*window.swept).max(axis=0)[column]
    around = (
        np.maximum(outlines.half_length - outlines.half_width, 0.0)[target] + half + SAMPLE_SPACING
    )
    around = around + swept
    return np.asarray(np.where(seen, square, math.inf).min(axis=0) < around * around)


def _circles(
    window: Window, column: Integers, outlines: Outlines, half: Floats, half_width: Floats
) -> tuple[Floats, Floats]:
    """(P,) gap and heading of the line, as `nearest_in_corridor`, by circles (C, P)."""
    share = np.linspace(-1.0, 1.0, CIRCLES)[:, None]
    out = share * np.maximum(outlines.half_length - outlines.half_width, 0.0)
    x, y = outlines.x + out * outlines.cosine, outlines.y + out * outlines.sine
    off_x = x[:, None, :] - window.x[:, column]
    off_y = y[:, None, :] - window.y[:, column]
    square = off_x * off_x + off_y * off_y
    seen = window.s[:, None] <= window.view[column]
    place = np.where(seen, square, math.inf).argmin(axis=1)
    pair = np.arange(len(column))
    circle = np.arange(CIRCLES)[:, None]
    dx, dy = off_x[circle, place, pair], off_y[circle, place, pair]
    cosine, sine = window.cosine[place, column], window.sine[place, column]
    s = window.s[place] + cosine * dx + sine * dy
    left = cosine * dy - sine * dx
    begins = s - np.minimum(outlines.half_width, outlines.half_length)
    is_ahead = (s[CIRCLES // 2] > 0.0) | (begins > half_width - AHEAD)
    to_left, to_right = window.swept
    free = half + np.where(left > 0.0, to_left[place, column], to_right[place, column])
    free = free + _corner(outlines, cosine, sine)
    fits = is_ahead & (np.abs(left) < free) & (s < window.view[column] + SAMPLE_SPACING)
    gaps: Any = np.where(fits, begins - half_width, math.inf)
    nearest = gaps.argmin(axis=0)
    heading = np.arctan2(sine[nearest, pair], cosine[nearest, pair])
    return gaps[nearest, pair], heading


def _corner(outlines: Outlines, cosine: Floats, sine: Floats) -> Floats:
    """(C, P) meters by which the corners of a footprint are farther across a line than the circles
    in it: `w (|sin| + |cos| - 1)` at its front and rear, half its width being `w`."""
    ahead = np.abs(outlines.cosine * cosine + outlines.sine * sine)
    across = np.abs(outlines.sine * cosine - outlines.cosine * sine)
    ends = np.array([1.0, *[0.0] * (CIRCLES - 2), 1.0])[:, None]
    return np.asarray(ends * outlines.half_width * (ahead + across - 1.0))
