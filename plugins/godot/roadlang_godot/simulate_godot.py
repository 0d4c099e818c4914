"""`simulate with godot`: scenes driven with physics in a Godot engine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Duration, Flag, Simulator, Word, option

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from roadlang.api import Controller, Scene, Trace


@dataclass(frozen=True)
class Godot(Simulator):
    """Drive in a Godot engine, with wheels, springs and tire friction."""

    name: ClassVar[str] = "godot"

    duration: Duration = option(60.0, above=0, maximum=3600, help="how long at most")
    step: Duration = option(0.02, minimum=0.001, maximum=1, help="time between two records")
    headless: Flag = option(True, help="without a window, as fast as it can")
    road: Word = option("mesh", words=("mesh", "tiles"), help="along the curve, or pixel by pixel")

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        """Start an engine, build the scene, drive it, and end the engine."""
        (trace,) = self.drive_all([scene], [controllers])
        return trace

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterable[Trace]:
        """The same with one engine for all scenes; each has a world without a past."""
        from .simulate import Settings, drive_scenes

        settings = Settings(self.duration, self.step, self.headless, self.road)
        yield from drive_scenes(scenes, settings, controllers)
