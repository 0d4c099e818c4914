"""Agents and objects that the file itself puts in one place: `check` finds them without geometry.

Only those in one lane of one road are compared: their distance along the lane is never less than
that between them. All others are looked at when scenes are made.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.category import PEDESTRIAN
from ..ir.scenario import ScenarioActor
from ..ir.values import Flag, PassCall
from ..world.placement_faults import DEFAULT_APART
from .constant_kinds import constant_kind

_ROUNDING = 1e-6


@dataclass(frozen=True)
class _OccupiedRange:
    """Arc length of the middle, half the length, and the distance that is kept, None if unsaid."""

    actor: ScenarioActor
    at: float
    half: float
    apart: float | None


def fixed_overlaps(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL616 for each agent or object that stands in the one before it in its lane."""
    lanes: dict[tuple[object, ...], list[_OccupiedRange]] = {}
    for actor in scenario.actors.values():
        standing = _standing(actor, scenario)
        if standing is not None:
            lanes.setdefault(_lane(actor, scenario), []).append(standing)
    for group in lanes.values():
        ordered = sorted(group, key=lambda item: item.at)
        for first, second in pairwise(ordered):
            stated = [apart for apart in (first.apart, second.apart) if apart is not None]
            room = second.at - first.at - first.half - second.half
            if room < max(stated, default=DEFAULT_APART) - _ROUNDING:
                yield _fault(first, second, group, room)


def _fault(
    item: _OccupiedRange, other: _OccupiedRange, group: list[_OccupiedRange], room: float
) -> Diagnostic:
    first, second = (item, other) if group.index(item) < group.index(other) else (other, item)
    gap = f"there are {room:.3g}m between them" if room > 0 else f"they overlap by {-room:.3g}m"
    help_ = f"{gap}: leave more room, or write `overlap: true` if that is meant"
    return diagnose(
        Code.NO_ROOM, second.actor.span, name=second.actor.name, other=first.actor.name, help=help_
    )


def _standing(actor: ScenarioActor, scenario: IndexedScenario) -> _OccupiedRange | None:
    """Where it stands, if that is the same in every scene."""
    options = actor.options
    free = {"count", "offset", "side", "heading", "spacing"} & options.keys()
    if (
        actor.on not in scenario.roads
        or actor.at_fraction
        or free
        or not isinstance(actor.kind, PassCall)
    ):
        return None
    if options.get("overlap", Flag(False)) != Flag(False):
        return None
    at, apart = _constant(actor.at, scenario), None
    if "apart" in options:
        apart = _constant(options["apart"], scenario)
        if apart is None:
            return None
    kind = constant_kind(actor.kind, scenario)
    length = getattr(kind, "length", None)
    if at is None or not isinstance(length, float | int):
        return None
    return _OccupiedRange(actor, at, length / 2, apart)


def _lane(actor: ScenarioActor, scenario: IndexedScenario) -> tuple[object, ...]:
    """A key that is equal for those that stand in the same lane, one after the other."""
    options = actor.options
    if "lane" in options:
        lane = _constant(options["lane"], scenario)
        return (actor.on, lane if lane is not None else actor.name)
    is_agent = actor in scenario.source.agents
    # Pedestrians begin beside the lanes of vehicles where the road has a lane for them.
    assert isinstance(actor.kind, PassCall)
    walks = getattr(constant_kind(actor.kind, scenario), "category", "") == PEDESTRIAN
    return (actor.on, "default", is_agent, walks, options.get("facing"))


def _constant(value: Any, scenario: IndexedScenario) -> float | None:
    try:
        low, high = scenario.value_bounds.of(value)
    except (TypeError, ValueError):
        return None
    return low if low == high else None
