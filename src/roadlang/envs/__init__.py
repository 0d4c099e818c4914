"""Scenes as environments of gymnasium, to train and test policies in.

    from roadlang.envs import SceneEnv, SceneVectorEnv

Needs gymnasium: `pip install "roadlang[gym]"`.
"""

try:
    import gymnasium as _gymnasium  # noqa: F401 - whether it is there
except ImportError as error:
    raise ImportError(
        'roadlang.envs needs the package gymnasium: pip install "roadlang[gym]"'
    ) from error

from ..simulation.observing.observation_vector import ObservationVector
from .rewards import Transition
from .scene_env import SceneEnv
from .scene_vector_env import SceneVectorEnv
from .settings import EnvSettings

__all__ = ["EnvSettings", "ObservationVector", "SceneEnv", "SceneVectorEnv", "Transition"]
