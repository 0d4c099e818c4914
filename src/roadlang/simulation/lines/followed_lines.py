"""The lines that agents follow: as far beside the middles of their lanes as they are moved."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..shallow_copies import shallow
from .lane_guides import LaneGuides
from .lateral_motion import SLOW, LateralMotion

IN_THE_MIDDLE = 0.02
"""Meters: a line so close to the middle of a lane is the middle."""
BEGINNING = 3.0
"""Seconds after which who begins where its lane leads over to the next is on the line there."""
SAME = 1e-6
"""Meters: a line asked for so close to where the one before was is that one."""


@dataclass
class FollowedLines:
    """Columns (N,) of lines, left of the reference lines.

    In lanes of constant widths these are moved by `lateral`. Where widths change, that moves them
    beside a guide: a line asked for is kept as far from the middle of the nearest lane as it is
    when it is asked for.
    """

    lateral: LateralMotion
    guides: LaneGuides
    line: Integers
    """which of the reference lines"""
    guide: Integers
    """number in `guides`, -1 for none"""
    start: Integers
    """that at the start of the drive"""
    asked: Floats
    """offset that was asked for last, NaN for none"""
    before: tuple[Floats, Integers, Floats]
    """of the lines before the present ones: offset when they were left, guide, and target"""
    drift: Floats
    """m/s to the left at which agents, who head along the road, come nearer to their guides at the
    start of the drive"""

    @classmethod
    def at_rest(
        cls, offset: Floats, guides: LaneGuides, line: Integers, guide: Integers,
        start: tuple[Floats, Floats],
    ) -> FollowedLines:  # fmt: skip
        """Lines `offset` left of their guides, or of the reference lines for those without, of
        agents that begin at arc lengths with speeds: `start`."""
        along, speed = start
        nothing = np.full(len(offset), np.nan)
        before = (nothing, guide.copy(), offset.copy())
        beside, drift = np.zeros(len(offset)), np.zeros(len(offset))
        if not guides.is_empty:  # who begins where its lane leads over stands in the lane
            beside = guides.beside(guide, along)
            beside[np.abs(beside) < IN_THE_MIDDLE] = 0.0
            slope = np.where(guide >= 0, guides.ahead(guide, along)[1], 0.0)
            drift = -slope * np.maximum(speed, SLOW)
            drift[drift * beside > 0.0] = 0.0  # where a lane ends there is no time to lose
        lateral = LateralMotion.at_rest(offset + beside)
        begun = cls(
            lateral, guides, line, guide.copy(), guide, nothing.copy(), before, drift
        )  # fmt: skip
        begun._begin(np.flatnonzero(beside))
        return begun

    def copied(self) -> FollowedLines:
        """The same, of which time may pass apart."""
        found = shallow(self)
        found.lateral = shallow(self.lateral)
        return found

    def restart(self, agents: Integers) -> None:
        """Those of some agents are as at the start of the drive."""
        self.lateral.restart(agents)
        self.guide[agents] = self.start[agents]
        self.asked[agents] = self.before[0][agents] = np.nan
        if self.guided:
            self._begin(agents[self.start[agents] >= 0])

    def take(self, rows: Integers) -> FollowedLines:
        """Those of some agents."""
        offset, guide, target = self.before
        return FollowedLines(
            self.lateral.take(rows), self.guides, self.line[rows], self.guide[rows],
            self.start[rows], self.asked[rows], (offset[rows], guide[rows], target[rows]),
            self.drift[rows],
        )  # fmt: skip

    def offset(self, rows: Any, along: Floats) -> Floats:
        """Of some agents, where the lines would be at arc lengths if they moved no further."""
        offset: Floats = self.lateral.offset[rows]
        if not self.guided:
            return offset
        return np.asarray(offset + self.guides.offset(self.guide[rows], along))

    @property
    def guided(self) -> bool:
        """Whether any line may have a guide."""
        return not self.guides.is_empty

    def kind(self, agent: int) -> tuple[int, float]:
        """Of the line that an agent now follows: agents beside the same reference line for which
        this is the same follow the same line."""
        return int(self.guide[agent]), float(self.lateral.offset[agent])

    def ahead(self, rows: Any, distance: Floats | float, speed: Floats, along: Floats) -> Any:
        """Of some agents: offset, slope (1) and curvature (1/m) of the line a distance on, at arc
        lengths `along`, and which lines are not parallel to the reference lines (None: all are)."""
        offset, slope, bend, moving = self.lateral.ahead(rows, distance, speed)
        if not self.guided:
            return offset, slope, bend, moving
        guide = self.guide[rows]
        middle, turned, bent = self.guides.ahead(guide, along)
        guided: Booleans = guide >= 0
        if moving is not None:
            turned = turned + np.where(moving, slope, 0.0)
            bent = bent + np.where(moving, bend, 0.0)
            guided = guided | moving
        return offset + middle, turned, bent, guided

    def move(self, target: Floats, time: Floats | None, along: Floats, speed: Floats) -> bool:
        """Where `target` is a number, and not that of the present move, moves that begin now and
        take `time` seconds; without a time, the line is there at once. Whether any line may have
        changed."""
        if not self.guided:
            return self.lateral.move(target, time)
        has_guides = self.guides.first[self.line] >= 0
        # Who has no lane stays as far beside the road as it began.
        has_guides &= (self.guide >= 0) | (self.start >= 0) | (target != self.lateral.start)
        new = np.flatnonzero(has_guides & np.isfinite(target) & (target != self.asked))
        beside = np.where(has_guides, np.nan, target)
        if len(new):
            beside[new] = self._moved_to(new, target[new], along[new], speed[new])
            self.asked[new] = target[new]
        return self.lateral.move(beside, time) or len(new) > 0

    def target(self, agent: int, along: float) -> float:
        """Where the line of an agent is to be, left of the reference line at an arc length."""
        rows = np.array([agent])
        guide = self.guides.offset(self.guide[rows], np.array([along])) if self.guided else 0.0
        return float((self.lateral.target[rows] + guide)[0])

    def is_as_at_start(self, agent: int) -> bool:
        """Whether the line of an agent is to be what it was at the start."""
        lateral = self.lateral
        return bool(
            lateral.target[agent] == lateral.start[agent] and self.guide[agent] == self.start[agent]
        )

    def go_on(self, earlier: FollowedLines, rows: Integers, old: Integers, along: Floats) -> None:
        """Lines of some agents are where those of agents `old` are, of lines `earlier` at arc
        lengths `along`, and move as these do; beside a guide they are at rest until they are
        moved."""
        self.lateral.go_on(earlier.lateral, rows, old)
        guided = (self.guide[rows] >= 0) | (earlier.guide[old] >= 0)
        self.guide[rows] = -1
        self.asked[rows] = self.before[0][rows] = np.nan
        if guided.any():
            offset = earlier.offset(old, along)
            self.lateral.settle(rows[guided], offset[guided])

    def advance(self, speed: Floats, seconds: float) -> None:
        """Time passes; agents go at these speeds."""
        self.lateral.advance(speed, seconds)

    def _begin(self, rows: Integers) -> None:
        """Lines of some agents with a guide, at the start of the drive, move onto it."""
        rows = rows[self.lateral.target[rows] != 0.0]
        if len(rows):
            self.lateral.seen_from(rows, np.zeros(len(rows)), self.drift[rows])
            target = np.full(len(self.guide), np.nan)
            target[rows] = 0.0
            self.lateral.move(target, np.full(len(target), BEGINNING))

    def _moved_to(self, new: Integers, target: Floats, along: Floats, speed: Floats) -> Floats:
        """(n,) how far beside their new guides lines of agents are to be, which are now seen from
        these."""
        offset, was, then = self.before
        back = np.abs(target - offset[new]) < SAME
        guide, beside = self.guides.nearest(self.line[new], target, along)
        beside = np.where(np.abs(beside) < IN_THE_MIDDLE, 0.0, beside)
        guide, beside = np.where(back, was[new], guide), np.where(back, then[new], beside)
        here, slope, _ = self.guides.ahead(self.guide[new], along)
        there, turned, _ = self.guides.ahead(guide, along)
        goes = (guide != self.guide[new]) | (beside != self.lateral.target[new])
        rows = new[goes]
        offset[rows] = (here + self.lateral.offset[new])[goes]
        was[rows], then[rows] = self.guide[rows], self.lateral.target[rows]
        drift = (slope - turned) * np.maximum(speed, SLOW)
        self.lateral.seen_from(rows, (here - there)[goes], drift[goes])
        self.guide[rows] = guide[goes]
        return beside
