"""How fast the bends ahead may be driven: a speed for each place of a line, planned backward."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...geometry.curves.bend_speeds import squares_before, squares_in_bends
from ..lines.lines import Lines
from ..state.world import World
from ..tapes.traced import TracedColumn
from ..vehicles import compiled
from ..vehicles.motion import Track


class BendSpeeds:
    """The plans of the agents of a world, each made when its limits are first needed; agents that
    follow one line with the same limits share one."""

    def __init__(self, world: World) -> None:
        count, cells = len(world.present), world.track.lines.cells
        self._agents = np.arange(count)
        self._limits = np.zeros((2, count))
        self._guides = np.full(count, -1)
        self._plans = np.zeros((0, cells))
        self._plan_of = np.full(count, -1)
        """the plan of each agent"""
        self._first = -world.track.first
        """by how much the cells of its plan are further on than those of its line"""
        self._made = 0
        """how often plans were made"""
        self._latest: tuple[Any, ...] = ()
        """agents and limits whose plans were last seen to be there: controllers look twice, and
        at every step with the same"""

    def at(
        self,
        world: World,
        rows: Any,
        lateral: Floats | float,
        braking: Floats | float,
        distance: Floats | float,
    ) -> Floats:
        """(N,) the greatest speeds a distance on, m/s, with `braking` before bends that are driven
        with a lateral acceleration of at most `lateral`."""
        track = world.track.of_rows(rows)
        wanted = (rows, lateral, braking)
        if not self._was_latest(*wanted) or self._follows_others(world, rows):
            self._plan(world, track, *wanted)
        self._latest = wanted  # the next may be these very arrays
        along = track.wrapped(world.motion.along[rows] + distance)
        if isinstance(along, TracedColumn):
            return along.value_of_cell(self._plans.ravel(), self._first[rows], track, self._made)
        if compiled.is_loaded():
            return compiled.looked_up(self._plans.ravel(), self._first[rows], track, along)
        cell, _ = track.cell(along)
        return np.asarray(self._plans.ravel().take(cell + self._first[rows]))

    def _follows_others(self, world: World, rows: Any) -> bool:
        """Whether agents follow other guides than those that were planned for."""
        if not world.followed.guided:
            return False
        return bool(np.count_nonzero(world.followed.guide[rows] != self._guides[rows]))

    def _was_latest(self, rows: Any, lateral: Any, braking: Any) -> bool:
        if not self._latest:
            return False
        known_rows, known_lateral, known_braking = self._latest
        return (
            (known_rows is rows or _is_same(known_rows, rows))
            and (known_lateral is lateral or _is_same(known_lateral, lateral))
            and (known_braking is braking or _is_same(known_braking, braking))
        )

    def _plan(
        self, world: World, track: Track, rows: Any, lateral: Floats | float,
        braking: Floats | float,
    ) -> None:  # fmt: skip
        """Make the plans that are new."""
        limits = np.empty((2, len(track.row)))
        limits[0], limits[1] = lateral, braking
        guides = world.followed.guide[rows]
        new = (limits != self._limits[:, rows]).any(axis=0) | (guides != self._guides[rows])
        if new.any():
            self._made += 1
            self._limits[:, rows], self._guides[rows] = limits, guides
            line, fresh, guide = track.row[new], limits[:, new], guides[new]
            first, group = _groups((*fresh, guide, line))
            agents = self._agents[rows][new]
            places = self._put(agents, group, len(first))
            self._first[agents] = self._plan_of[agents] * self._plans.shape[1] - track.first[new]
            bend = _bend_beside(world, line[first], guide[first])
            least = fresh[:, first]
            self._plans[places] = planned(track.lines, line[first], least[0], least[1], bend)

    def _put(self, agents: Integers, group: Integers, count: int) -> Integers:
        """Places for `count` new plans, those of the groups of agents; others that nobody needs
        any more are overwritten."""
        self._plan_of[agents] = -1
        is_free = np.ones(len(self._plans), dtype=bool)
        is_free[self._plan_of[self._plan_of >= 0]] = False
        free = np.flatnonzero(is_free)[:count]
        more = np.zeros((count - len(free), self._plans.shape[1]))
        places = np.append(free, len(self._plans) + np.arange(len(more)))
        if len(more):
            before = self._plans
            self._plans = np.concatenate((before, more)) if len(before) else more
        self._plan_of[agents] = places[group]
        return places

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        self._agents = np.arange(len(agents))
        self._limits, self._guides = self._limits[:, agents], self._guides[agents]
        self._plan_of, self._first = self._plan_of[agents], self._first[agents]
        self._latest = ()


def _groups(columns: tuple[Any, ...]) -> tuple[Integers, Integers]:
    """Of rows (N,) that are equal in all columns: the first of each group, and of each row the
    number of its group."""
    order = np.lexsort(columns)
    begins = np.ones(len(order), dtype=bool)
    begins[1:] = np.logical_or.reduce([np.diff(column[order]) != 0 for column in columns])
    group = np.empty(len(order), dtype=np.int64)
    group[order] = np.cumsum(begins) - 1
    return order[begins], group


def _is_same(one: Any, other: Any) -> bool:
    """Whether two indices, numbers or columns are equal; they may be shown to be without a look."""
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.shape == other.shape and not np.count_nonzero(one != other)
    return type(one) is type(other) and bool(one == other)


def _bend_beside(world: World, row: Integers, guide: Integers) -> Floats | None:
    """(N, M) 1/m by which guides bend more than the lines `row`; None where there are none."""
    if not world.followed.guided:
        return None
    lines = world.track.lines
    along = lines.origin[row, None] + lines.spacing[row, None] * np.arange(lines.cells)
    return world.followed.guides.ahead(guide[:, None], along)[2]


_AT_ONCE = 48
"""Lines whose speeds are planned together with numpy, so few that they fit into the caches."""


def planned(
    lines: Lines, row: Integers, lateral: Floats, braking: Floats, bend: Floats | None = None
) -> Floats:
    """(N, M) greatest speeds at the ends of the cells of the lines `row`, which are followed where
    they bend by `bend` more."""
    gain = 2.0 * braking * lines.spacing[row]
    if compiled.is_loaded() and bend is None and not np.count_nonzero(lines.closed[row]):
        first = row * lines.cells
        return compiled.planned(lines.table, first, (lateral, gain), lines.cells)
    out = np.empty((len(row), lines.cells))
    for begin in range(0, len(row), _AT_ONCE):
        part = slice(begin, begin + _AT_ONCE)
        more = None if bend is None else bend[part]
        out[part] = _planned(lines, row[part], lateral[part], gain[part], more)
    return out


def _planned(
    lines: Lines, row: Integers, lateral: Floats, gain: Floats, bend: Floats | None
) -> Floats:
    """The same of some lines. `gain`: (N,) by how much squared speeds may grow from one cell to the
    one before."""
    curvature = lines.column(lines.seen_curvature)[row]
    curvature = curvature if bend is None else curvature + bend
    limits = squares_in_bends(curvature, lateral[:, None])
    square = squares_before(limits, gain)
    again = np.flatnonzero(lines.closed[row])
    if len(again):  # beyond the end of a closed line is its beginning
        cells = np.round(lines.length[row[again]] / lines.spacing[row[again]]).astype(np.int64)
        last = lines.last[row[again]]
        square[again, last] = np.minimum(square[again, last], square[again, last - cells])
        square[again] = squares_before(square[again], gain[again])
    ahead = np.minimum(square[:, :-1], square[:, 1:])
    square[:, :-1] = ahead
    return np.asarray(np.sqrt(square))
