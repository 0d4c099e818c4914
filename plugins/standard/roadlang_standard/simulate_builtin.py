"""`simulate with builtin`: drive scenes in the embedded engine, without anything to install."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Duration, Simulator, option

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from roadlang.api import Controller, EngineSettings, Scene, Sensor, Trace


@dataclass(frozen=True)
class Builtin(Simulator):
    """The embedded engine: a dynamic bicycle model, many scenes at once, nothing to install."""

    name: ClassVar[str] = "builtin"
    also_called: ClassVar[tuple[str, ...]] = ("embedded", "internal")
    is_default: ClassVar[bool] = True
    knows_levels: ClassVar[bool] = True

    duration: Duration = option(60.0, above=0, maximum=3600, help="maximum duration of a drive")
    step: Duration = option(0.1, minimum=0.001, maximum=1, help="sampling interval of the trace")
    control_step: Duration = option(
        0.04, minimum=0.001, maximum=1, help="interval between decisions of the controllers"
    )
    vehicle_step: Duration = option(
        0.02, minimum=0.001, maximum=0.05, help="time step of the equations of motion"
    )
    after_violation: Duration = option(
        None,
        minimum=0,
        help="how long a drive goes on after every `expect always` about it is violated; by "
        "default to its end; with expectations of other forms it always goes on to its end",
        example="2s",
    )

    def offers(self, sensor: type[Sensor]) -> bool:
        return sensor.is_computed()

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterable[Trace]:
        from roadlang.api import simulate_scenes

        yield from simulate_scenes(scenes, controllers, self.settings)

    @property
    def settings(self) -> EngineSettings:
        """Those of the engine, which environments step themselves."""
        from roadlang.api import EngineSettings

        from .engine_tables import BODIES

        return EngineSettings(
            self.duration,
            self.step,
            self.control_step,
            self.vehicle_step,
            math.inf if self.after_violation is None else self.after_violation,
            BODIES,
        )
