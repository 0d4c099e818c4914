"""What can be set of an environment."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from numbers import Real
from typing import Any

import numpy as np

from ..diagnostics import did_you_mean
from ..geometry.arrays import Floats
from ..simulation.observing.observation_vector import DISTANCES, ObservationVector
from .rewards import Transition

Reward = str | Callable[[Transition], Floats | float]


@dataclass(frozen=True)
class EnvSettings:
    """Settings of `SceneEnv` and `SceneVectorEnv`, SI units. Raises ValueError where one makes no
    sense."""

    agent: str | None = None
    """the agent that the actions drive; the first of the scene, if None"""
    reward: Reward | None = None
    """an `expect` of the file, a formula, or a function of a `Transition`; if None, the least
    margin of all `expect`s over the drive, or, of a file without any, the meters made"""
    scenes: int = 100
    """how many scenes of a file are sampled; each reset draws one of them"""
    scene_seed: int = 0
    """the seed that they are sampled with: other seeds, other scenes"""
    step: float = 0.1
    """seconds for which an action is held"""
    vehicle_step: float = 0.05
    """seconds, of the equations of motion"""
    duration: float = 60.0
    """seconds after which an episode is truncated"""
    acceleration: float = 4.0
    """m/s^2, of the action 1"""
    deceleration: float = 8.0
    """m/s^2, of the action -1"""
    distances: tuple[float, ...] = DISTANCES
    """meters ahead at which the path is seen"""
    agents: int = 4
    """how many of the nearest other agents are seen"""
    off_road_ends: bool = True
    """whether an episode ends where the signal `off_road` of the agent is above zero"""
    violation_ends: bool = False
    """whether an episode ends where the margin of an `expect` is negative"""

    def __post_init__(self) -> None:
        for name in ("step", "vehicle_step", "duration", "acceleration", "deceleration"):
            value = getattr(self, name)
            if not (_is_number(value) and 0.0 < value < math.inf):
                raise ValueError(f"{name} must be a number above 0, not {value!r}")
        for name, least in (("scenes", 1), ("scene_seed", 0), ("agents", 0)):
            value = getattr(self, name)
            if not _is_whole(value) or value < least:
                raise ValueError(
                    f"{name} must be a whole number of at least {least}, not {value!r}"
                )
            object.__setattr__(self, name, int(value))  # of numpy as well
        for name in ("off_road_ends", "violation_ends"):
            if not isinstance(getattr(self, name), bool | np.bool_):
                raise ValueError(f"{name} must be True or False, not {getattr(self, name)!r}")
            object.__setattr__(self, name, bool(getattr(self, name)))
        if not isinstance(self.agent, str | None):
            raise ValueError(f"agent must be the name of an agent or None, not {self.agent!r}")
        if not (self.reward is None or isinstance(self.reward, str) or callable(self.reward)):
            raise ValueError(
                f"reward must be the name of an `expect`, a formula, a function or None, not "
                f"{self.reward!r}"
            )
        if self.vehicle_step > 0.05 or self.step > 1.0:
            raise ValueError("vehicle_step may be at most 0.05 s, and step at most 1 s")
        is_several = isinstance(self.distances, Sequence | np.ndarray)
        if not is_several or not all(
            _is_number(distance) and 0.0 <= distance <= 1000.0 for distance in self.distances
        ):
            raise ValueError(f"distances must be numbers from 0 to 1000 m, not {self.distances!r}")

    @property
    def substeps(self) -> int:
        """Steps of the equations of motion for each action."""
        return max(1, round(self.step / self.vehicle_step))

    @property
    def dt(self) -> float:
        """Seconds: `vehicle_step`, or what is next to it and fits into a step."""
        return self.step / self.substeps

    @property
    def limit(self) -> int:
        """Actions after which an episode is truncated."""
        return max(1, round(self.duration / self.step))

    @property
    def vector(self) -> ObservationVector:
        """What is observed."""
        return ObservationVector(tuple(self.distances), self.agents)


def changed(settings: EnvSettings, changes: Mapping[str, Any], owner: str) -> EnvSettings:
    """Settings with changes that an `owner` was given. Raises TypeError for others than there are,
    ValueError for values that make no sense."""
    known = [field.name for field in fields(EnvSettings)]
    for name in changes:
        if name not in known:
            help_ = did_you_mean(name, known)
            if name == "render_mode":
                help_ = ("one `SceneEnv` draws pictures",)
            help_ = help_ or (f"its settings are {', '.join(known)}",)
            raise TypeError(f"{owner} has no setting `{name}`: {help_[0]}")
    return replace(settings, **changes)


def _is_number(value: Any) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)


def _is_whole(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)
