"""Many scenes side by side for Stable-Baselines3, whose vectors of environments are its own.

Needs stable-baselines3: `pip install "roadlang[sb3]"`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from gymnasium.spaces import Box, Dict, Space
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

try:
    from stable_baselines3.common.vec_env import VecEnv
except ImportError as error:
    raise ImportError(
        "roadlang.envs.stable_baselines needs the package stable-baselines3: "
        'pip install "roadlang[sb3]"'
    ) from error

from .observed import Observed
from .scene_pool import Source
from .scene_vector_env import SceneVectorEnv
from .settings import EnvSettings

Indices = int | Iterable[int] | None
"""Which environments, as Stable-Baselines3 names them; None: all."""


class SceneVecEnv(VecEnv):  # type: ignore[misc]
    """What `SceneVectorEnv` is, as a `VecEnv`: `PPO("MlpPolicy", SceneVecEnv("scene.rl", 64))`.

    Source and settings are those of `SceneVectorEnv`, without `autoreset_mode`: after the end of an
    episode the next one begins at once, and the last observation is `infos[i]`'s
    `terminal_observation`. Observations of agents with sensors are maps of one level, which
    Stable-Baselines3 needs: `state`, and `SENSOR/ARRAY` for each array; single numbers are (1,).
    Rewards are float32.
    """

    def __init__(
        self,
        source: Source,
        num_envs: int,
        settings: EnvSettings | None = None,
        *,
        scenes_each: int | None = None,
        **changes: Any,
    ) -> None:
        self.envs = SceneVectorEnv(
            source,
            num_envs,
            settings,
            autoreset_mode=AutoresetMode.SAME_STEP,
            scenes_each=scenes_each,
            **changes,
        )
        """the environments"""
        self._actions: NDArray[Any] = np.zeros(0)
        single = self.envs.single_observation_space
        super().__init__(self.envs.num_envs, _one_level(single), self.envs.single_action_space)

    def reset(self) -> Observed:
        """Begin anew everywhere, with the seeds of the last call of `seed`, if there was one since
        the last reset."""
        if any(self._options):
            raise ValueError("environments side by side have no options of `reset`")
        has_seeds = any(seed is not None for seed in self._seeds)
        observed, info = self.envs.reset(seed=self._seeds if has_seeds else None)
        self.reset_infos = [{"scene": int(scene)} for scene in info["scene"]]
        self._reset_seeds()
        self._reset_options()
        return _flat(observed, 1)

    def step_async(self, actions: NDArray[Any]) -> None:
        """What to do next, (num_envs, 2)."""
        self._actions = actions

    def step_wait(self) -> tuple[Observed, NDArray[np.float32], NDArray[np.bool_], list[Any]]:
        """Hold the actions for `step` seconds."""
        observed, rewards, terminated, truncated, info = self.envs.step(self._actions)
        over = terminated | truncated
        infos = _apart(info, self.num_envs)
        for row, is_late in enumerate(truncated.tolist()):
            infos[row]["TimeLimit.truncated"] = is_late
        for row in over.nonzero()[0].tolist():
            infos[row]["terminal_observation"] = _flat(info["final_obs"][row], 0)
        return _flat(observed, 1), rewards.astype(np.float32), over, infos

    def close(self) -> None:
        """Nothing is left to be closed."""
        self.envs.close()

    def get_attr(self, attr_name: str, indices: Indices = None) -> list[Any]:
        """What an attribute of the environments is: the same for each."""
        value = None if attr_name == "render_mode" else getattr(self.envs, attr_name)
        return [value] * len(self._chosen(indices))

    def set_attr(self, attr_name: str, value: Any, indices: Indices = None) -> None:
        """Refused: environments side by side share what they are."""
        raise _shared(f"set `{attr_name}`")

    def env_method(
        self, method_name: str, *arguments: Any, indices: Indices = None, **options: Any
    ) -> list[Any]:
        """Refused: environments side by side have no methods of their own."""
        raise _shared(f"call `{method_name}`")

    def env_is_wrapped(self, wrapper_class: type[Any], indices: Indices = None) -> list[bool]:
        """None of them is."""
        return [False] * len(self._chosen(indices))

    def _chosen(self, indices: Indices) -> Sequence[int]:
        if indices is None:
            return range(self.num_envs)
        return [indices] if isinstance(indices, int) else list(indices)


def _shared(what: str) -> AttributeError:
    return AttributeError(
        f"cannot {what} of one environment: they are driven side by side and share their settings;"
        " give these to `SceneVecEnv`, or use `SceneEnv` with `make_vec_env`"
    )


def _one_level(space: Space[Any]) -> Space[Any]:
    if not isinstance(space, Dict):
        return space
    state, sensors = space["state"], space["sensors"]
    assert isinstance(sensors, Dict)
    arrays = {
        f"{sensor}/{name}": _at_least_one_long(array)
        for sensor, readings in sensors.items()
        if isinstance(readings, Dict)
        for name, array in readings.items()
    }
    return Dict({"state": state, **arrays})


def _at_least_one_long(space: Space[Any]) -> Space[Any]:
    """Stable-Baselines3 wants arrays of one number to be (1,)."""
    if not isinstance(space, Box) or space.shape:
        return space
    return Box(space.low.item(), space.high.item(), (1,), space.dtype.type)


def _flat(observed: Observed, axes: int) -> Observed:
    """On one level, of a single environment (`axes` 0) or of several (1)."""
    if not isinstance(observed, dict):
        return observed
    arrays = {
        f"{sensor}/{name}": array[..., None] if np.ndim(array) == axes else array
        for sensor, readings in observed["sensors"].items()
        for name, array in readings.items()
    }
    return {"state": observed["state"], **arrays}


def _apart(info: dict[str, Any], count: int) -> list[dict[str, Any]]:
    """The `info` of each of so many environments, as `SceneEnv` gives it."""
    margins = {name: part.tolist() for name, part in info["margins"].items() if name[0] != "_"}
    ends = {name: info[name].tolist() for name in ("collided", "off_road", "arrived", "violated")}
    return [
        {
            "margins": {name: column[row] for name, column in margins.items()},
            **{name: column[row] for name, column in ends.items()},
        }
        for row in range(count)
    ]
