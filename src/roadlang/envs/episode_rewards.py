"""The reward of a step, from what happened in it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from .rewards import Transition
from .scene_pool import ScenePool
from .settings import Reward

RewardFunction = Callable[[Transition], Floats]


def reward_function(reward: Reward | None, pool: ScenePool) -> RewardFunction:
    """The reward (N,) of a transition of N agents."""
    if callable(reward):
        return _OwnReward(reward)
    return _LeastMargin(pool.reward) if pool.reward else _moved


# Classes and functions with a name, so that environments can be pickled.


@dataclass(frozen=True)
class _OwnReward:
    """What a user's function gives, checked."""

    function: Callable[[Transition], Any]

    def __call__(self, happened: Transition) -> Floats:
        return _checked(self.function(happened), len(happened.speed))


@dataclass(frozen=True)
class _LeastMargin:
    names: tuple[str, ...]

    def __call__(self, happened: Transition) -> Floats:
        margins = [happened.margins[name] for name in self.names]
        return margins[0] if len(margins) == 1 else np.asarray(np.minimum.reduce(margins))


def _moved(happened: Transition) -> Floats:
    return happened.moved


def _checked(values: Any, count: int) -> Floats:
    """What a user's function gave. Raises ValueError for what is no finite number for each."""
    try:
        rewards = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"the reward must be numbers, not {values!r}") from None
    if rewards.shape not in ((), (count,)):
        raise ValueError(f"the reward has the shape {rewards.shape}, not {(count,)}")
    if not np.isfinite(rewards).all():
        raise ValueError("the reward is not finite")
    return np.broadcast_to(rewards, (count,))
