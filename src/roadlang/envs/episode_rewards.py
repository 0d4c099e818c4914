"""The reward of a step, from what happened in it."""

from __future__ import annotations

from collections.abc import Callable
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
        function: Callable[[Transition], Any] = reward
        return lambda happened: _checked(function(happened), len(happened.speed))
    names = pool.reward
    if not names:
        return lambda happened: happened.moved
    return lambda happened: _least([happened.margins[name] for name in names])


def _least(margins: list[Floats]) -> Floats:
    return margins[0] if len(margins) == 1 else np.asarray(np.minimum.reduce(margins))


def _checked(values: Any, count: int) -> Floats:
    """What a user's function gave. Raises ValueError for what is no finite number for each."""
    rewards = np.asarray(values, dtype=np.float64)
    if rewards.shape not in ((), (count,)):
        raise ValueError(f"the reward has the shape {rewards.shape}, not {(count,)}")
    if not np.isfinite(rewards).all():
        raise ValueError("the reward is not finite")
    return np.broadcast_to(rewards, (count,))
