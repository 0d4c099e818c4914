"""What all agents of a world are to do until the next step."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.control import Control, ControlBatch
from .controllers import UNDRIVEN_BRAKING


@dataclass
class Decision:
    """Columns (N,). NaN in `steering` and `acceleration` means undecided, until `close` is
    called."""

    steering: Floats
    acceleration: Floats
    heading: Floats | None = None
    pose: Floats | None = None
    """(N, 4) x, y, heading, speed; NaN for agents that follow the equations of motion"""
    limit: Floats | None = None
    """(N,) the greatest acceleration where it is decided by controllers before the one in charge;
    infinite for none"""
    failures: dict[int, str] = field(default_factory=dict)
    """by agent: why its controller fails from now on"""

    @classmethod
    def open(cls, driven: Booleans) -> Decision:
        """No decision yet for agents that are `driven`; the others brake."""
        return cls(np.where(driven, math.nan, 0.0), np.where(driven, math.nan, -UNDRIVEN_BRAKING))

    def copy(self) -> Decision:
        """The same, in separate columns, where nobody goes by a heading or a pose yet."""
        return Decision(self.steering.copy(), self.acceleration.copy())

    @property
    def is_plain(self) -> bool:
        """Whether it has no columns other than steering and acceleration."""
        others = (self.heading, self.pose, self.limit)
        return not self.failures and all(column is None for column in others)

    @property
    def has_open(self) -> bool:
        """Whether anything is undecided for any agent."""
        if math.isfinite(self.steering.dot(self.acceleration)):  # so is every number of both
            return False
        return bool(self.is_open.any())

    @property
    def is_open(self) -> Booleans:
        """(N,) whether something is undecided."""
        return np.isnan(self.steering) | np.isnan(self.acceleration)

    def put(self, rows: Integers, found: ControlBatch) -> None:
        """Add the decisions of the controllers in charge of some agents."""
        self.steering[rows], self.acceleration[rows] = found.steering, found.acceleration
        if found.heading is not None:
            if self.heading is None:
                self.heading = np.full(len(self.steering), math.nan)
            self.heading[rows] = found.heading
        if found.pose is not None:
            if self.pose is None:
                self.pose = np.full((len(self.steering), 4), math.nan)
            self.pose[rows] = found.pose
        self._bound(rows, found)
        self._note_failures(rows, found)

    def fill(self, rows: Integers, found: ControlBatch) -> None:
        """Add decisions of earlier controllers, where something is still undecided."""
        for mine, theirs in (
            (self.steering, found.steering),
            (self.acceleration, self._within_limit(rows, found.acceleration)),
        ):
            mine[rows] = np.where(np.isnan(mine[rows]), theirs, mine[rows])
        self._bound(rows, found)
        self._note_failures(rows, found)

    def _note_failures(self, rows: Integers, found: ControlBatch) -> None:
        for place, reason in (found.failures or {}).items():
            self.failures[int(rows[place])] = reason

    def _bound(self, rows: Integers, found: ControlBatch) -> None:
        """A controller that leaves the acceleration open may limit what those before it decide."""
        if found.acceleration_limit is None:
            return
        if self.limit is None:
            self.limit = np.full(len(self.steering), math.inf)
        limit = np.where(np.isnan(self.acceleration[rows]), found.acceleration_limit, math.inf)
        self.limit[rows] = np.fmin(self.limit[rows], limit)

    def _within_limit(self, rows: Integers, acceleration: Floats) -> Floats:
        return acceleration if self.limit is None else np.minimum(acceleration, self.limit[rows])

    def single(self, row: int) -> Control:
        """That of one agent."""
        heading = math.nan if self.heading is None else float(self.heading[row])
        pose = None
        if self.pose is not None and math.isfinite(self.pose[row, 0]):
            x, y, toward, speed = self.pose[row].tolist()
            pose = (x, y, toward, speed)
        steering, acceleration = float(self.steering[row]), float(self.acceleration[row])
        return Control(steering, acceleration, heading, pose=pose)

    def close(self) -> None:
        """Set everything undecided to 0."""
        for column in (self.steering, self.acceleration):
            column[is_open := np.isnan(column)] = 0.0
        if self.limit is not None:
            self.acceleration[is_open] = np.minimum(0.0, self.limit[is_open])
