"""Simulators of other tools, where the kind of `simulate` is asked for."""

from __future__ import annotations

import re

_ENGINES = re.compile(
    r"carla|metadrive|newtonian|lgsvl|esmini|sumo|beamng|webots|airsim|commonroad|gazebo|unity"
    r"|unreal",
    re.IGNORECASE,
)
_ELSEWHERE = (
    "a plugin brings other simulators; without one, files are written for them: `emit opendrive` "
    "(CARLA, esmini, SUMO), `emit openscenario` (esmini, CARLA), `emit sumo`, `emit commonroad`"
)


def kind_help(verb: str, name: str) -> tuple[str, ...]:
    """Help for a kind of another tool that none here resembles."""
    return (_ELSEWHERE,) if verb == "simulate" and _ENGINES.fullmatch(name) else ()
