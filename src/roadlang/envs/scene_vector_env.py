"""Many scenes side by side as a vector environment of gymnasium."""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from typing import Any

import numpy as np
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from ..diagnostics.arguments import whole_number
from ..geometry.arrays import Booleans
from .episode_rewards import reward_function
from .observed import Observed, observation_space, row_of
from .reset_options import known_options
from .rows import Rows, rows_of
from .scene_pool import Source, pool_of
from .seeds import seed_of
from .settings import EnvSettings, changed
from .spaces import ACTIONS, checked_actions

Array = NDArray[Any]


class SceneVectorEnv(VectorEnv[Observed, Array, Array]):
    """`num_envs` of what `SceneEnv` is, driven side by side: thousands in little more time than
    one.

    Source and settings are those of `SceneEnv`, and so is what each does: the one at place i with
    the seed s is to the last bit a `SceneEnv` with this seed, for its first `scenes_each` episodes;
    then it begins with its first scene again, until the next `reset`, which draws others. (Scenes
    in which another agent waits for a condition, or that have junctions or agents longer than 7 m,
    are driven one by one: that is as slow as `num_envs` times `SceneEnv`.)

    `autoreset_mode`: what happens after the end of an episode, as gymnasium defines it: `NEXT_STEP`
    (the next action is not looked at, and gives the first observation of the next episode and the
    reward 0), `SAME_STEP` (that observation comes at once, and the last one is in
    `info["final_obs"]`) or `DISABLED` (`reset(options={"reset_mask": mask})`).
    """

    def __init__(
        self,
        source: Source,
        num_envs: int,
        settings: EnvSettings | None = None,
        *,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        scenes_each: int | None = None,
        **changes: Any,
    ) -> None:
        num_envs = whole_number("num_envs", num_envs, least=1)
        if scenes_each is not None:
            scenes_each = whole_number("scenes_each", scenes_each, least=1)
        self.settings = changed(settings or EnvSettings(), changes, type(self).__name__)
        self.pool = pool_of(source, self.settings)
        self.num_envs = num_envs
        self.names = self.settings.vector.names
        modes = [mode.value for mode in AutoresetMode]
        if autoreset_mode not in [*modes, *AutoresetMode]:
            listed = ", ".join(modes)
            raise ValueError(f"autoreset_mode must be one of {listed}, not {autoreset_mode!r}")
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self.metadata = {"render_modes": [], "autoreset_mode": self.autoreset_mode}
        self.single_observation_space = observation_space(self.settings.vector, self.pool.sensors)
        self.single_action_space = ACTIONS
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(ACTIONS, num_envs)
        self._each = scenes_each or max(1, 64 // num_envs)
        self._reward = reward_function(self.settings.reward, self.pool)
        self._rows: Rows | None = None
        self._over = np.zeros(num_envs, dtype=bool)
        self._generators: list[np.random.Generator] = []

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Observed, dict[str, Any]]:
        """Begin anew everywhere, or where `options["reset_mask"]` is True.

        `seed`: of the first, and one more for each of the others; or one for each. Without one,
        the generators go on.
        """
        mask = known_options(options, "reset_mask").get("reset_mask")
        if mask is not None:
            return self._reset_some(_checked_mask(mask, self.num_envs), seed)
        self._seed(seed)
        draws = [
            [int(generator.integers(len(self.pool.scenes))) for _ in range(self._each)]
            for generator in self._generators
        ]
        self._rows = rows_of(self.pool, draws, self.settings)
        self._over[:] = False
        every = np.ones(self.num_envs, dtype=bool)
        return self._rows.observe(), {"scene": self._rows.scenes, "_scene": every}

    def step(self, actions: Array) -> tuple[Observed, Array, Array, Array, dict[str, Any]]:
        """Hold an action for each, (num_envs, 2), for `step` seconds."""
        rows = self._running()
        over, mode = self._over, self.autoreset_mode
        if mode == AutoresetMode.DISABLED and np.count_nonzero(over):
            raise RuntimeError("an episode is over: reset(options={'reset_mask': ...}) it first")
        happened, ends = rows.step(checked_actions(actions, self.num_envs, 2))
        rewards = np.array(self._reward(happened), dtype=np.float64)
        terminated = ends.terminated
        truncated = ends.late & ~terminated
        info: dict[str, Any] = dict(ends.reasons)
        if mode == AutoresetMode.NEXT_STEP and np.count_nonzero(over):
            rewards[over] = 0.0
            ran = ~over
            terminated, truncated = terminated & ran, truncated & ran
            info = {name: column & ran for name, column in info.items()}
            rows.advance(over.nonzero()[0])
        self._over = terminated | truncated
        observed = rows.observe()
        ran = ~over
        info = _masked(info | {"margins": _masked(dict(happened.margins), ran)}, ran)
        if mode == AutoresetMode.SAME_STEP and np.count_nonzero(self._over):
            observed, info = self._first_step(observed, info)
        return observed, rewards, terminated, truncated, info

    def _first_step(
        self, observed: Observed, info: dict[str, Any]
    ) -> tuple[Observed, dict[str, Any]]:
        """Where an episode is over, the next one begins; `info` has how the last one ended."""
        over = self._over.copy()
        last = np.full(self.num_envs, None, dtype=object)
        for row in over.nonzero()[0]:
            last[row] = deepcopy(row_of(observed, int(row)))
        self._running().advance(over.nonzero()[0])
        return self._running().observe(), {
            **info,
            **_masked({"final_obs": last, "final_info": dict(info)}, over),
        }

    def _reset_some(
        self, mask: Booleans, seed: int | Sequence[int | None] | None
    ) -> tuple[Observed, dict[str, Any]]:
        if seed is not None:
            raise ValueError("with a reset_mask there is no seed: each goes on with its scenes")
        rows = self._running()
        rows.advance(np.flatnonzero(mask))
        self._over &= ~mask
        return rows.observe(), {"scene": rows.scenes, "_scene": mask.copy()}

    def _seed(self, seed: int | Sequence[int | None] | None) -> None:
        if seed is None and self._generators:
            return
        if isinstance(seed, Sequence | np.ndarray):
            seeds = [seed_of(each) for each in seed]
        else:
            first = seed_of(seed)
            if first is not None:
                self._np_random, self._np_random_seed = seeding.np_random(first)
            seeds = [None if first is None else first + i for i in range(self.num_envs)]
        if len(seeds) != self.num_envs:
            raise ValueError(f"{len(seeds)} seeds for {self.num_envs} environments")
        self._generators = [seeding.np_random(seed)[0] for seed in seeds]

    def _running(self) -> Rows:
        if self._rows is None:
            raise RuntimeError("reset() comes before the first step()")
        return self._rows


def _masked(info: dict[str, Any], mask: Booleans) -> dict[str, Any]:
    """Each value with the mask of who has it, as gymnasium keeps `info` of vectors."""
    return {**info, **{f"_{name}": mask.copy() for name in info}}


def _checked_mask(mask: Any, count: int) -> Booleans:
    if not isinstance(mask, np.ndarray) or mask.shape != (count,) or mask.dtype != np.bool_:
        raise ValueError(f"reset_mask must be a numpy array of {count} booleans")
    return mask
