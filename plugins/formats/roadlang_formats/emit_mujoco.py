"""`emit mujoco`: a model of MuJoCo in which a car can be driven on the roads of a scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene


@dataclass(frozen=True)
class MujocoBackend(RoadBackend):
    """Roads, obstacles and a car with four wheels as an MJCF model, which MuJoCo simulates."""

    name: ClassVar[str] = "mujoco"

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .mjcf.document import document

        return {"mjcf.xml": document(scene)}
