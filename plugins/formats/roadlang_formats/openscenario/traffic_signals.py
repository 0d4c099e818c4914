"""The phases of traffic signals, for the signals of the OpenDRIVE file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from ..opendrive.elements import put

if TYPE_CHECKING:
    from roadlang.api import SceneControl

    from ..opendrive.junctions import NumberedJunction
    from ..opendrive.signals import RoadSignal

_LAMPS = {"green": "off;off;on", "yellow": "off;on;off", "red": "on;off;off"}
"""Red, yellow and green."""
_SHORTEST = 1e-3
"""Seconds of a phase."""


def put_traffic_signals(
    parent: Element, junctions: Sequence[NumberedJunction], lights: Sequence[RoadSignal]
) -> None:
    """One controller for each junction with signals."""
    controlled = [found for found in junctions if found.junction.control.kind == "signals"]
    if not controlled:
        return
    group = put(parent, "TrafficSignals")
    for junction in controlled:
        here = [light for light in lights if light.junction == junction.id and light.phases]
        controller = put(group, "TrafficSignalController", name=junction.name)
        for number, (seconds, place, color) in enumerate(_parts(junction.junction.control), 1):
            phase = put(controller, "Phase", name=f"phase {number}", duration=seconds)
            for light in here:
                shown = color if place in light.phases else "red"
                put(phase, "TrafficSignalState", trafficSignalId=light.id, state=_LAMPS[shown])


def _parts(control: SceneControl) -> list[tuple[float, int, str]]:
    """Seconds, phase and color of what follows each other in a cycle, from the begin of the drive:
    `offset` seconds of it have passed then."""
    parts: list[tuple[float, int, str]] = []
    for place, phase in enumerate(control.phases):
        parts += [(phase.green, place, "green"), (phase.yellow, place, "yellow")]
        parts.append((phase.all_red, place, "red"))
    passed = control.offset % control.cycle if control.cycle > 0.0 else 0.0
    for number, (seconds, place, color) in enumerate(parts):
        if passed < seconds:
            first = (seconds - passed, place, color)
            rest = (passed, place, color)
            parts = [first, *parts[number + 1 :], *parts[:number], rest]
            break
        passed -= seconds
    return [part for part in parts if part[0] > _SHORTEST]
