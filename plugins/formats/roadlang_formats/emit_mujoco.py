"""`emit mujoco`: a model of MuJoCo in which a car can be driven on the roads of a scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from roadlang.api import ScenarioContents, Scene


@dataclass(frozen=True)
class MujocoBackend(Backend):
    """Roads, obstacles and a car with four wheels as an MJCF model, which MuJoCo simulates."""

    name: ClassVar[str] = "mujoco"

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """It is of roads."""
        if not (contents.roads or contents.networks):
            yield "it has no road"

    def files(self, scene: Scene) -> Mapping[str, str]:
        from .mjcf.document import document

        return {"mjcf.xml": document(scene)}
