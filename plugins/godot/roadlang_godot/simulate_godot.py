"""`simulate with godot`: drive scenes in Godot, with physics."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Duration, Flag, Integer, Simulator, String, Word, option
from roadlang_standard.sense_camera import Camera

from .usual_port import USUAL_PORT

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from roadlang.api import Controller, Scene, Sensor, Trace

_WITHOUT_HOST = "without `host`, roadlang starts Godot itself"


@dataclass(frozen=True)
class GodotSimulator(Simulator):
    """Godot with its physics engine: wheels, suspension and tire friction."""

    name: ClassVar[str] = "godot"
    at_once: ClassVar[int] = 8

    duration: Duration = option(60.0, above=0, maximum=3600, help="maximum duration of a drive")
    step: Duration = option(0.02, minimum=0.001, maximum=1, help="sampling interval of the trace")
    headless: Flag = option(True, help="run without a window, as fast as possible")
    road: Word = option(
        "mesh",
        words=("mesh", "tiles"),
        help="build the road as a mesh along the curve, or as pixel tiles",
    )
    host: String | None = option(
        None, help="host of a Godot that is running, such as your game; without it, one is started"
    )
    port: Integer = option(USUAL_PORT, minimum=1, maximum=65535, help="port of that Godot")
    transport: Word = option(
        "udp", words=("udp", "websocket"), help="transport protocol of that Godot"
    )

    def offers(self, sensor: type[Sensor]) -> bool:
        """What Python measures, and cameras."""
        return sensor.is_computed() or sensor is Camera

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterable[Trace]:
        """Drive the scenes with one engine, each in a world without a past."""
        from .drive.simulate import Settings, drive_scenes
        from .engines.running_engine import RunningEngine

        running = None
        if self.host is not None:
            running = RunningEngine(self.host, self.port, self.transport, _WITHOUT_HOST)
        settings = Settings(self.duration, self.step, self.headless, self.road, running)
        yield from drive_scenes(scenes, settings, controllers)
