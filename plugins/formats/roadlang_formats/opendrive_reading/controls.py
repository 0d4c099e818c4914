"""The traffic lights, and the stop and yield signs, of an OpenDRIVE map."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Literal

from roadlang.geometry import MapControl

from .records import Contact, OpenDriveRecord, RoadRecord, SignalRecord

Rule = Literal["signals", "stop", "yield"]
_SIGNS: Mapping[str, Rule] = {"206": "stop", "205": "yield"}
"""Of the German catalog, which CARLA and others use everywhere."""
_PEDESTRIANS = "1000002"
_FARTHEST = 50.0
"""Meters before the end of a road up to which a light or sign is for the junction there."""


def map_controls(record: OpenDriveRecord, numbers: Mapping[str, int]) -> tuple[MapControl, ...]:
    """Those at the ends of the roads of a network, whose edges have `numbers` by their ids."""
    known = {
        signal.id: signal
        for road in record.roads.values()
        for signal in road.signals
        if signal.type  # a reference has none
    }
    found: dict[MapControl, None] = {}
    for road in record.roads.values():
        for signal in road.signals:
            rule = _rule(known.get(signal.id, signal))
            if rule is None:
                continue
            for id, end in _arms(road, signal, record):
                if id in numbers:
                    found[MapControl(rule, ((numbers[id], end),))] = None
    return tuple(found)


def _rule(signal: SignalRecord) -> Rule | None:
    if signal.is_dynamic:
        return None if signal.type == _PEDESTRIANS else "signals"
    return _SIGNS.get(signal.type)


def _arms(
    road: RoadRecord, signal: SignalRecord, record: OpenDriveRecord
) -> Iterator[tuple[str, Contact]]:
    """The end of the road whose traffic it is for; of a connecting road, that of the one before."""
    if road.junction in record.junctions:
        link = road.successor if signal.orientation == "-" else road.predecessor
        if link is not None and link.kind == "road":
            yield link.id, link.contact
        return
    ends: dict[Contact, float] = {"start": signal.s, "end": road.length - signal.s}
    wanted: Mapping[str, Contact] = {"+": "end", "-": "start"}
    nearer: Contact = "start" if ends["start"] < ends["end"] else "end"
    end = wanted.get(signal.orientation, nearer)
    after = road.link(end)
    if after is not None and after.kind == "junction" and ends[end] <= _FARTHEST:
        yield road.id, end
