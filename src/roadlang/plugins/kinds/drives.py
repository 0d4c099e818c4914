"""Kinds of drives: controllers of agents, simulators."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from ...ir.control import Control, Observation
    from ...ir.scene import Scene
    from ...ir.trace import Trace


class Controller(Kind):
    """`drive with`: what steers an agent. Every engine can drive one that implements `control`; one
    that does not is driven by engines that know it by its name."""

    verb: ClassVar[str] = "drive"

    def control(self, observation: Observation) -> Control:
        """What to do until the next step, from what is seen now.

        Returns a `Control` of finite numbers; anything else is RL474.
        """
        raise NotImplementedError


class Simulator(Kind):
    """`simulate with`: where scenes are driven."""

    verb: ClassVar[str] = "simulate"
    required_methods: ClassVar[tuple[str, ...]] = ("drive", "drive_all")

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        """Drive a scene.

        `controllers` holds, by agent, those that are written in Python; what else steers is in
        `scene.agents[i].drive`. Returns a `Trace`; anything else is RL474. Raise `DiagnosticError`
        where the engine cannot be reached or cannot drive the scene.
        """
        raise NotImplementedError

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterable[Trace]:
        """Drive several scenes: an engine that takes long to start is started once for all.

        Returns a `Trace` for each scene, in their order. By default `drive` is called for each.
        """
        for scene, own in zip(scenes, controllers, strict=True):
            yield self.drive(scene, own)
