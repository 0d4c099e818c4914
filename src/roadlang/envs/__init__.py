"""Scenes as environments of gymnasium, to train and test policies in.

    from roadlang.envs import SceneEnv, SceneVectorEnv

Importing it registers `gymnasium.make("roadlang/Scene-v0", source="scene.rl")`.

Needs gymnasium: `pip install "roadlang[gym]"`.
"""

try:
    import gymnasium as _gymnasium
except ImportError as error:
    raise ImportError(
        'roadlang.envs needs the package gymnasium: pip install "roadlang[gym]"'
    ) from error

from ..simulation.observing.observation_vector import ObservationVector
from .rewards import Transition
from .scene_env import SceneEnv
from .scene_vector_env import SceneVectorEnv
from .settings import EnvSettings

_gymnasium.register(
    "roadlang/Scene-v0",
    entry_point=f"{__name__}:SceneEnv",
    vector_entry_point=f"{__name__}:SceneVectorEnv",
)

__all__ = ["EnvSettings", "ObservationVector", "SceneEnv", "SceneVectorEnv", "Transition"]
