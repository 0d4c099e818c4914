"""Traffic lights and signs at the ends of roads, and the controllers that switch them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from ..road_signs import SIGNS
from .elements import put

if TYPE_CHECKING:
    from .junctions import NumberedJunction
    from .road_parts import OpenDriveRoad

_BESIDE = 1.0
"""Meters from the edge of the road to a pole."""


@dataclass(frozen=True)
class RoadSignal:
    """A light or sign for some lanes at the end of a road. `phases`: those in which it is green."""

    id: int
    part: OpenDriveRoad
    end: str
    lanes: tuple[int, ...]
    kind: str
    phases: tuple[int, ...] = ()
    junction: int = 0


def signals(junctions: Sequence[NumberedJunction]) -> tuple[RoadSignal, ...]:
    """One for the lanes of each end of a road that have green in the same phases; signs for all."""
    found: list[RoadSignal] = []
    for junction in junctions:
        control = junction.junction.control
        groups: dict[tuple[int, str, tuple[int, ...]], set[int]] = {}
        ends: dict[tuple[int, str], OpenDriveRoad] = {}
        for road in junction.roads:
            at = road.source
            minor = control.kind == "all_way_stop" or at.part.road.name in control.minor
            if control.kind == "signals":
                phases = tuple(
                    place
                    for place, phase in enumerate(control.phases)
                    if road.connection.id in phase.connections
                )
            elif control.kind in SIGNS and minor:
                phases = ()
            else:
                continue
            groups.setdefault((at.part.id, at.end, phases), set()).add(at.lane)
            ends[at.part.id, at.end] = at.part
        for (number, end, phases), lanes in sorted(groups.items()):
            found.append(
                RoadSignal(
                    len(found) + 1,
                    ends[number, end],
                    end,
                    tuple(sorted(lanes)),
                    control.kind,
                    phases,
                    junction.id,
                )
            )
    return tuple(found)


def put_signals(
    parent: Element, part: OpenDriveRoad, found: Sequence[RoadSignal], left_hand: bool
) -> None:
    """The `signals` of a road: at its ends, on the side of the traffic that they are for."""
    here = [signal for signal in found if signal.part is part]
    if not here:
        return
    group = put(parent, "signals")
    for signal in here:
        at_start = signal.end == "start"
        station = part.stations[0 if at_start else -1]
        left, right = (float(half) for half in part.section.half_widths(station))
        on_left = at_start != left_hand
        light = signal.kind == "signals"
        element = put(
            group,
            "signal",
            s=0.0 if at_start else part.line.length,
            t=left + _BESIDE if on_left else -right - _BESIDE,
            id=signal.id,
            name=f"signal {signal.id}",
            dynamic="yes" if light else "no",
            orientation="-" if at_start else "+",
            zOffset=3.0 if light else 2.0,
            type="1000001" if light else SIGNS[signal.kind],
            country="OpenDRIVE" if light else "DE",
            subtype="-1",
            height=1.0,
            width=0.4,
        )
        for lane in signal.lanes:
            put(element, "validity", fromLane=lane, toLane=lane)


def put_controllers(root: Element, found: Sequence[RoadSignal]) -> dict[int, list[int]]:
    """The `controller` elements, one for the lights that are green in the same phases.

    Returns their numbers by junction.
    """
    groups: dict[tuple[int, tuple[int, ...]], list[int]] = {}
    for signal in found:
        if signal.kind == "signals":
            groups.setdefault((signal.junction, signal.phases), []).append(signal.id)
    numbers: dict[int, list[int]] = {}
    for id, ((junction, _), members) in enumerate(sorted(groups.items()), start=1):
        controller = put(root, "controller", id=id, name=f"controller {id}", sequence=0)
        for member in members:
            put(controller, "control", signalId=member, type="0")
        numbers.setdefault(junction, []).append(id)
    return numbers
