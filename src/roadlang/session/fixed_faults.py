"""Faults that every scene would have: `check` finds them before anything is sampled.

What the scenario alone decides is found without numpy. Only where a position may be beyond the end
of a road, where a road may not close, and where a table or map is named, is the road made.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..diagnostics import Diagnostic
from ..evaluate.indexed_scenario import IndexedScenario
from ..files.reading import UnreadableFile, read_file, read_start
from ..ir.scenario import (
    FileSource,
    Scenario,
    ScenarioActor,
    ScenarioImage,
)
from ..ir.values import PassCall, TextValue, Value
from ..plugins.kinds import Controller
from ..plugins.registry import Registry
from ..plugins.stated_bounds import OptionRange
from ..world.lanes.lane_plan import default_lane_kind
from ..world.lanes.planned_lanes import PlannedLane, planned_lanes
from ..world.placement_faults import missing_scale, no_place_on_earth, unknown_lane
from .fixed_closed_roads import fixed_closed_roads
from .fixed_lane_changes import lanes_not_beside
from .fixed_overlaps import fixed_overlaps
from .fixed_positions import intervals_off_road, position_fault
from .fixed_roads import fixed_roads
from .fixed_runs import equal_outputs, large_grids
from .fixed_surfaces import road_lane_plan, surface_faults
from .missing_sensors import missing_sensors
from .refused_options import refused_options
from .unsupported import unsupported_parts


def fixed_faults(source: Scenario, registry: Registry) -> list[Diagnostic]:
    """Kinds that refuse their options, images without scale or with an impossible origin, lanes and
    sensors that are not there, positions, intervals and patches of surfaces beyond their roads,
    things in one place, formulas that cannot be evaluated on closed roads, equal outputs, and what
    backends and the simulator do not support.
    Where there are none: roads that cannot be made, parts of maps that are not there, and grids
    that are too large.

    Roads from picture files are not checked: they are read when scenes are made.
    """
    scenario = IndexedScenario(source, registry, _nothing_measured)
    found = [
        *refused_options(scenario),
        *_missing_scales(scenario),
        *_wrong_origins(scenario),
        *intervals_off_road(scenario),
        *surface_faults(scenario),
        *missing_sensors(scenario),
    ]
    for actor in (*source.agents, *source.objects):
        if actor.on in scenario.roads:
            fault = next(_lane_faults(actor, scenario), None) or position_fault(actor, scenario)
            found += [fault] if fault is not None else []
    found += [*fixed_overlaps(scenario), *fixed_closed_roads(scenario), *equal_outputs(scenario)]
    found += unsupported_parts(scenario)
    return found or [*fixed_roads(scenario), *large_grids(scenario)]


def _nothing_measured(call: PassCall, candidates: Any, element: int) -> Any:
    raise NotImplementedError


def _missing_scales(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    for network in scenario.networks.values():
        image = scenario.source_of(network)
        if isinstance(image, ScenarioImage) and not _has_scale(image, scenario):
            from ..images.image_scale import unusable_world_file

            sources = [link.source for link in scenario.chain(image)]
            files = [Path(file.resolved) for file in sources if isinstance(file, FileSource)]
            yield missing_scale(image, unusable_world_file(files[0]) if files else None)


def _wrong_origins(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    for image in scenario.source.images:
        written = image.options.get("origin")
        origin = None if written is None else scenario.value_bounds.option(written)
        if isinstance(origin, OptionRange) or not isinstance(origin, tuple):
            continue  # nothing is known of it
        if all(part.low == part.high for part in origin):
            fault = no_place_on_earth(image, *(math.degrees(part.low) for part in origin))
            yield from () if fault is None else (fault,)


def _has_scale(image: ScenarioImage, scenario: IndexedScenario) -> bool:
    chain = [link for link in scenario.chain(image) if isinstance(link, ScenarioImage)]
    if any("scale" in link.options for link in chain):
        return True
    root = chain[-1]
    has_reader = any(call.verb == "read" for call in root.passes)
    return isinstance(root.source, FileSource) and not has_reader and _file_has_scale(root.source)


def _file_has_scale(source: FileSource) -> bool:
    from ..images.image_header import read_header
    from ..images.image_scale import scale_in_file

    path = Path(source.resolved)
    try:
        start = read_start(path, 64)
        is_tiff = start[:4] in (b"II*\x00", b"MM\x00*")
        content = read_file(path) if is_tiff else start
    except UnreadableFile:
        return True  # what is wrong with the file is said where it is read
    header = read_header(content) if is_tiff else None
    return scale_in_file(path, content, header.format if header else "") is not None


def _lane_faults(actor: ScenarioActor, scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL613 for the lane that an actor begins in, and for those that its controllers move to."""
    lanes = planned_lanes(road_lane_plan(scenario.roads[str(actor.on)], scenario), scenario)
    if lanes is None:
        return
    ids = tuple(lane.id for lane in lanes)
    written = [(actor.options.get("lane"), actor.span_of("lane"))]
    for call in actor.drive:
        kind = scenario.kind(call)[1]
        if issubclass(kind, Controller):
            places = [call.option_spans.get(name, call.span) for name in kind.lane_options]
            written += zip(map(call.options.get, kind.lane_options), places, strict=True)
    for value, span in written:
        lane = None if value is None else _fixed_number(value, scenario)
        fault = None if lane is None else unknown_lane(actor, lane, ids, span)
        if fault is not None:
            yield fault
    start = _start_lane(actor, lanes, scenario)
    if start is not None:
        yield from lanes_not_beside(actor, start, lanes, scenario)


def _start_lane(
    actor: ScenarioActor, lanes: tuple[PlannedLane, ...], scenario: IndexedScenario
) -> int | None:
    """The lane in which an actor begins, where no draw and no other actor decides it."""
    if "lane" in actor.options:
        return _fixed_number(actor.options["lane"], scenario)
    if actor.options.keys() & {"side", "offset"} or isinstance(actor.options.get("at"), PassCall):
        return None
    usual = default_lane_kind(scenario, drivable=True)
    own = [lane.id for lane in lanes if lane.direction == "forward" and lane.kind is usual]
    return min(own, key=abs, default=None)


def _fixed_number(value: Value, scenario: IndexedScenario) -> int | None:
    """None for words, for lanes by other agents, and for what is drawn."""
    if isinstance(value, TextValue | PassCall):
        return None
    low, high = scenario.value_bounds.of(value)
    return round(low) if low == high else None
