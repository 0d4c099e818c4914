"""A drive as the floating car data of SUMO (`--fcd-output`)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

from ..decimals import bearing, decimals
from ..opendrive.elements import put
from .vehicle_classes import has_wheels

if TYPE_CHECKING:
    from roadlang.api import Scene, Trace


def drive_text(scene: Scene, trace: Trace) -> str:
    """Where all agents are at each time. SUMO has the front of a vehicle, and angles clockwise from
    north in degrees."""
    root = Element("fcd-export")
    agents = [
        (actor, trace.agents[actor.name]) for actor in scene.agents if actor.name in trace.agents
    ]
    there = {actor.name: found.samples_there for actor, found in agents}
    for step, time in enumerate(trace.time.tolist()):
        moment = put(root, "timestep", time=_time_text(time))
        for actor, found in agents:
            if step >= there[actor.name]:
                continue
            x, y, heading, speed = (
                float(getattr(found, name)[step]) for name in ("x", "y", "heading", "speed")
            )
            half = 0.5 * actor.length
            put(
                moment,
                "vehicle" if has_wheels(actor) else "person",
                id=actor.name,
                x=decimals(x + half * math.cos(heading), 3),
                y=decimals(y + half * math.sin(heading), 3),
                angle=decimals(bearing(heading, 3), 3),
                type=actor.kind,
                speed=decimals(speed, 3),
            )
    indent(root, " ")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'


def _time_text(time: float) -> str:
    """Seconds with two decimals, as SUMO writes them, or with more if the step is shorter."""
    text = f"{time:.6f}"
    return text[:-4] + text[-4:].rstrip("0")
