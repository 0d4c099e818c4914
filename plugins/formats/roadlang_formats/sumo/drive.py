"""A drive as the floating car data of SUMO (`--fcd-output`)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

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
        moment = put(root, "timestep", time=f"{time:.2f}")
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
                x=f"{x + half * math.cos(heading):.3f}",
                y=f"{y + half * math.sin(heading):.3f}",
                angle=f"{(90.0 - math.degrees(heading)) % 360.0:.3f}",
                type=actor.kind,
                speed=f"{speed:.3f}",
            )
    indent(root, " ")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'
