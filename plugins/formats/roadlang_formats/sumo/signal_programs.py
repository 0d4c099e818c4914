"""The phases of signals as programs of SUMO."""

from __future__ import annotations

from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from ..opendrive.elements import put

if TYPE_CHECKING:
    from .nodes import SumoNode

_SHORTEST = 1e-3
"""Seconds of a phase."""


def put_program(parent: Element, node: SumoNode) -> None:
    """The `tlLogic` of a junction with signals, which changes as that of the scene does."""
    if node.kind != "traffic_light" or node.junction is None:
        return
    control = node.junction.control
    program = put(parent, "tlLogic", id=node.id, type="static", programID="0")
    # Seconds that have passed of the first phase begin it so much earlier.
    program.set("offset", f"{-control.offset + 0.0:.12g}")
    for phase in control.phases:
        green = frozenset(phase.connections)
        for seconds, color in (
            (phase.green, "green"),
            (phase.yellow, "yellow"),
            (phase.all_red, "red"),
        ):
            if seconds > _SHORTEST:
                put(program, "phase", duration=seconds, state=_state(node, green, color))


def _state(node: SumoNode, green: frozenset[int], color: str) -> str:
    """A letter for each link: `G`, `g` for who yields to another with green, `y`, `r`."""
    has_green = [link.connection is not None and link.connection.id in green for link in node.links]
    letters = []
    for number, is_green in enumerate(has_green):
        if not is_green or color == "red":
            letters.append("r")
        elif color == "yellow":
            letters.append("y")
        else:
            yields = any(has_green[other] for first, other in node.yields if first == number)
            letters.append("g" if yields else "G")
    return "".join(letters)
