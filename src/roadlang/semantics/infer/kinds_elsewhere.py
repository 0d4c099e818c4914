"""What is of other tools, or of one's own, where a kind of `simulate`, `emit` or `drive` is asked
for."""

from __future__ import annotations

import re

_ENGINES = re.compile(
    r"carla|metadrive|newtonian|lgsvl|esmini|sumo|beamng|webots|airsim|commonroad|gazebo|unity"
    r"|unreal",
    re.IGNORECASE,
)
_CONTROLLERS = re.compile(r"pid|mpc|lqr|rl|ppo|sac|dqn|custom|my_\w+|ros|cpp|matlab", re.IGNORECASE)
_FILES = (
    "`emit opendrive` (CARLA, esmini, SUMO), `emit openscenario` (esmini, CARLA), `emit sumo`, "
    "`emit commonroad`"
)
_HELP = {
    "simulate": "other simulators need a plugin; without one, write files for them: " + _FILES,
    "emit": f"files for other simulators: {_FILES}, `emit gltf` (Unreal, Unity)",
}
_OWN = (
    "a controller of your own is a program (`drive with process`), a network (`drive with onnx`) "
    "or a plugin (`roadlang plugins new NAME --kind drive`)"
)


def kind_help(verb: str, name: str) -> tuple[str, ...]:
    """Help for a kind that none here resembles."""
    if verb == "drive" and _CONTROLLERS.fullmatch(name):
        return (_OWN,)
    return (_HELP[verb],) if verb in _HELP and _ENGINES.fullmatch(name) else ()
