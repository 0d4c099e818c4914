"""Drives of a car with sensors."""

from __future__ import annotations

from typing import Any

from roadlang import testing
from roadlang.ir.readings import SensorRecord
from roadlang.session.drives import Drive

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (300m, 40m)] }, lanes: 2 }\n"
SECONDS = 4.0


def agent(body: str) -> str:
    """A scene with one car that drives at 10 m/s and begins at that speed."""
    drive = "drive with lane_follow { speed: 10m/s }"
    return f"{ROAD}agent ego is car on main at 5m {{ start_speed: 10m/s, {drive}\n {body} }}\n"


def runs(text: str, n: int = 1, kinds: tuple[Any, ...] = (), **options: Any) -> list[Drive]:
    """Drives of 4 s with a decision every 40 ms."""
    return list(testing.sample(text, n, kinds=kinds).run("builtin", duration=SECONDS, **options))


def record(drive: Drive, sensor: str) -> SensorRecord:
    """What a sensor of `ego` measured."""
    (found,) = (one for one in drive.readings if (one.agent, one.sensor) == ("ego", sensor))
    return found
