"""One scene at a time as an environment of gymnasium."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from .episode_rewards import reward_function
from .episodes import Episodes
from .observed import Observed, observation_space, row_of
from .reset_options import known_options
from .scene_pool import Source, pool_of
from .seeds import seed_of
from .settings import EnvSettings, changed
from .spaces import ACTIONS, checked_actions
from .top_view import Picture, TopView

_ONLY = np.zeros(1, dtype=np.int64)


class SceneEnv(gymnasium.Env[Observed, NDArray[np.float32]]):
    """An agent of a scene, driven by actions in the embedded engine; all others drive themselves.

    `source`: a scene file, what `roadlang.load` gave, a scene or a list of them. Settings are those
    of `EnvSettings`, as keywords. Of a file, `scenes` scenes are sampled at the start, and each
    reset draws one of them. Observations are as `ObservationVector` says (`names`: of its numbers);
    where the agent has sensors, `{"state": that, "sensors": {NAME: {ARRAY: ...}}}`.
    Actions are steering (1: as far to the left as the agent can) and acceleration (1:
    `acceleration`, -1: brakes with `deceleration`). `info` has the number of the `scene`, the
    `margins` of the expectations, and how the episode ended. Raises DiagnosticError for what is
    wrong with the scenes, the agent (RL731) or the reward (RL730).
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"]}  # noqa: RUF012 - as gymnasium's

    def __init__(
        self,
        source: Source,
        settings: EnvSettings | None = None,
        *,
        render_mode: str | None = None,
        **changes: Any,
    ) -> None:
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode must be `rgb_array` or None, not {render_mode!r}")
        self.render_mode = render_mode
        self.settings = changed(settings or EnvSettings(), changes, type(self).__name__)
        self.metadata = {**self.metadata, "render_fps": max(1, round(1.0 / self.settings.step))}
        self.pool = pool_of(source, self.settings)
        self.names = self.settings.vector.names
        self.observation_space = observation_space(self.settings.vector, self.pool.sensors)
        self.action_space = ACTIONS
        self._reward = reward_function(self.settings.reward, self.pool)
        self._scene = 0
        self._episodes: Episodes | None = None
        self._view: TopView | None = None

    def __repr__(self) -> str:
        count = len(self.pool.scenes)
        driven = self.pool.scenes[0].agents[self.pool.driven[0]].name
        return f"<SceneEnv: {driven} in {count} scene{'' if count == 1 else 's'}>"

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observed, dict[str, Any]]:
        """Begin one of the scenes; `options={"scene": 3}` says which, by its place in the list."""
        super().reset(seed=seed_of(seed))
        scene = int(self.np_random.integers(len(self.pool.scenes)))
        chosen = known_options(options, "scene")
        if chosen:
            scene = _number(chosen["scene"], len(self.pool.scenes))
        self._episodes = Episodes(self.pool, [scene], self.settings)
        self._view = None
        self._scene = scene
        index = self.pool.scenes[scene].index
        return row_of(self._episodes.observe(_ONLY), 0), {"scene": index}

    def step(
        self, action: NDArray[np.float32]
    ) -> tuple[Observed, float, bool, bool, dict[str, Any]]:
        """Hold an action for `step` seconds."""
        episodes = self._running("step")
        actions = checked_actions(action, 2)[None]
        happened, ends = episodes.step(_ONLY, actions)
        terminated = bool(ends.terminated[0])
        return (
            row_of(episodes.observe(_ONLY), 0),
            float(self._reward(happened)[0]),
            terminated,
            bool(ends.late[0]) and not terminated,
            {
                "margins": {name: float(margin[0]) for name, margin in happened.margins.items()},
                **{name: bool(column[0]) for name, column in ends.reasons.items()},
            },
        )

    def render(self) -> Picture | None:
        """With `render_mode="rgb_array"` the scene from above, around the driven agent, as
        (480, 480, 3) RGB, north up, 6 pixels for each meter; otherwise None."""
        if self.render_mode is None:
            return None
        episodes = self._running("render")
        if self._view is None:
            self._view = TopView(self.pool.scenes[self._scene], self.pool.driven[self._scene])
        return self._view.picture(*episodes.places)

    def _running(self, method: str) -> Episodes:
        if self._episodes is None:
            raise RuntimeError(f"reset() comes before the first {method}()")
        return self._episodes


def _number(value: Any, count: int) -> int:
    if not isinstance(value, int | np.integer) or not 0 <= value < count:
        raise ValueError(f"there is no scene {value!r}: there are {count}, from 0")
    return int(value)
