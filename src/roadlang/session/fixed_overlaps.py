"""Agents and objects that the file itself puts in one place, on roads that are known.

Only those in one lane of one road are compared, by how far apart they are along the road. Where
that is too little they are placed as in scenes: in the outer lanes of a bend there is more room.
All others are looked at when scenes are made.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.category import PEDESTRIAN
from ..ir.scenario import ScenarioActor
from ..ir.values import Flag, PassCall, RandomValue
from ..world.placement_faults import DEFAULT_APART, row_or_anywhere
from .constant_kinds import constant_kind

_LONGEST_LANE = 4.0
"""Times the length of its road, more than a lane has in any bend that vehicles can drive."""


@dataclass(frozen=True)
class _OccupiedRange:
    """Arc length of the middle, half the length, half the shorter side, and the distance that is
    kept, None if unsaid."""

    actor: ScenarioActor
    at: float
    half: float
    inner: float
    apart: float | None


def fixed_overlaps(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL616 for each agent or object that stands in the one before it in its lane, and for copies
    that all stand in one place."""
    lanes: dict[tuple[object, ...], list[_OccupiedRange]] = {}
    for actor in scenario.actors.values():
        standing = _standing(actor, scenario)
        if standing is None:
            continue
        if "count" not in actor.options:
            lanes.setdefault(_lane(actor, scenario), []).append(standing)
        else:
            yield from _copies_in_one_place(standing, scenario)
    for group in lanes.values():
        ordered = sorted(group, key=lambda item: item.at)
        for first, second in pairwise(ordered):
            stated = [apart for apart in (first.apart, second.apart) if apart is not None]
            apart = max(stated, default=DEFAULT_APART)
            room = second.at - first.at - first.half - second.half
            missing = _missing(first, second, scenario) if room < apart else 0.0
            if missing > 0.0:
                gap = apart - missing
                yield _fault(first, second, group, gap if gap > 0.0 else min(room, gap))


def _copies_in_one_place(item: _OccupiedRange, scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL616 for a group of several copies, or of a drawn number that may be more than one: of its
    scenes those alone would be left that have a single copy."""
    options = item.actor.options
    count, lane, facing = (options.get(name) for name in ("count", "lane", "facing"))
    if isinstance(facing, RandomValue) or (lane is not None and _constant(lane, scenario) is None):
        return  # each copy may have another
    low, high = scenario.value_bounds.of(count)
    if low > 1 or (high > 1 and isinstance(count, RandomValue)):
        apart = DEFAULT_APART if item.apart is None else item.apart
        drawn = () if low > 1 else ("with the `count` that is drawn, only one copy fits",)
        name, help_ = item.actor.name, (*drawn, row_or_anywhere(2.0 * item.half + apart))
        yield diagnose(Code.NO_ROOM, item.actor.span, name=name, other=name, help=help_)


def _missing(first: _OccupiedRange, second: _OccupiedRange, scenario: IndexedScenario) -> float:
    """Meters of room that two lack in every scene; 0 where nothing is certain."""
    if scenario.is_random(scenario.roads[str(first.actor.on)]):
        is_same = _LONGEST_LANE * (second.at - first.at) < first.inner + second.inner
        return math.inf if is_same else 0.0
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.placement.distances_to_keep import missing_between

    candidate = fixed_candidate(index_scenario(scenario.source, scenario.registry))
    try:
        return missing_between(first.actor, second.actor, candidate)
    except DiagnosticError:
        return 0.0  # what is wrong with the road is said where it is made


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
    free = {"offset", "side", "heading", "spacing"} & options.keys()
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
    length, width = getattr(kind, "length", None), getattr(kind, "width", None)
    if at is None or not isinstance(length, float | int) or not isinstance(width, float | int):
        return None
    return _OccupiedRange(actor, at, length / 2, min(length, width) / 2, apart)


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
