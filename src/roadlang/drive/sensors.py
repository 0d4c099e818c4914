"""What records the readings of sensors in a drive."""

from __future__ import annotations

from collections.abc import Mapping

from ..plugins.kinds import Controller
from ..simulation.calling.controllers import Driver
from ..simulation.calling.sensors import SensorRecorder


def sensor_recorders(controllers: Mapping[str, Controller]) -> list[SensorRecorder]:
    """What will hold the readings of all sensors of a scene when it is driven."""
    found = []
    for agent, driver in controllers.items():
        for guarded in driver.sensors if isinstance(driver, Driver) else ():
            guarded.recorder = SensorRecorder(
                agent, guarded.sensor.name, guarded.arrays, guarded.files
            )
            found.append(guarded.recorder)
    return found
