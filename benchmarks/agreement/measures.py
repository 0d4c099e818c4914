"""How far two drives of one scene agree."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang.api import AgentTrace, Trace

OFF_ROAD = 0.3
"""Meters off the road that count as a failure."""
STEP = 0.1


@dataclass(frozen=True)
class Pair:
    """One scene in the embedded engine and in Godot; `ego` is looked at."""

    embedded: AgentTrace
    godot: AgentTrace

    @classmethod
    def of(cls, embedded: Trace, godot: Trace) -> Pair:
        """Of two drives."""
        return cls(embedded.agents["ego"], godot.agents["ego"])

    @property
    def fails(self) -> tuple[bool, bool]:
        """In the embedded engine, in Godot: whether it touches something or leaves the road."""
        return math.isfinite(failed_at(self.embedded)), math.isfinite(failed_at(self.godot))

    @property
    def time(self) -> NDArray[np.float64]:
        """(T,) seconds until either drive ends or fails."""
        ends = [failed_at(one) for one in (self.embedded, self.godot)]
        ends += [self.embedded.time[-1], self.godot.time[-1]]
        return np.arange(0.0, min(ends), STEP)

    @property
    def speed_errors(self) -> NDArray[np.float64]:
        """(T,) m/s."""
        one, other = self._both("speed")
        return one - other

    @property
    def lateral_correlation(self) -> float:
        """Of the cross-track errors, over time."""
        one, other = self._both("cross_track_error")
        if len(one) < 3 or min(one.std(), other.std()) < 1e-3:
            return math.nan
        return float(np.corrcoef(one, other)[0, 1])

    def _both(self, column: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        one, other = (
            np.interp(self.time, agent.time, getattr(agent, column))
            for agent in (self.embedded, self.godot)
        )
        return one, other


@dataclass(frozen=True)
class Agreement:
    """Of many scenes."""

    scenes: int
    failing: int
    """in Godot"""
    speed_rmse: float
    """m/s, over all times"""
    lateral_correlation: float
    """the median over scenes"""
    right_failing: float
    """share of the scenes failing in Godot that fail in the embedded engine too"""
    right_safe: float

    @classmethod
    def of(cls, pairs: Iterable[Pair]) -> Agreement:
        """Of these pairs of drives."""
        pairs = list(pairs)
        failing = [pair for pair in pairs if pair.fails[1]]
        safe = [pair for pair in pairs if not pair.fails[1]]
        errors = np.concatenate([pair.speed_errors for pair in pairs])
        return cls(
            len(pairs),
            len(failing),
            float(np.sqrt(np.mean(errors * errors))),
            float(np.nanmedian([pair.lateral_correlation for pair in pairs])),
            float(np.mean([pair.fails[0] for pair in failing])) if failing else 1.0,
            float(np.mean([not pair.fails[0] for pair in safe])) if safe else 1.0,
        )

    def __str__(self) -> str:
        return (
            f"{self.failing} of {self.scenes} fail in Godot; speed RMSE {self.speed_rmse:.2f} m/s, "
            f"lateral correlation {self.lateral_correlation:.2f}, right {self.right_failing:.0%} "
            f"of failing and {self.right_safe:.0%} of safe"
        )


def failed_at(agent: AgentTrace) -> float:
    """When it first touches something or leaves the road, infinity for never."""
    present = agent.present > 0.5
    bad = present & ((agent.contacts > 0) | (agent.off_road > OFF_ROAD))
    return float(agent.time[int(np.argmax(bad))]) if bad.any() else math.inf
