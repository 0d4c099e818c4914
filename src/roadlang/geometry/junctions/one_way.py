"""The roads of roundabouts, on which all lanes run the same way round."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

from ..lanes.cross_section import CrossSection


def sections_with_rings(
    sections: Mapping[int, CrossSection], directions: Mapping[int, bool]
) -> tuple[dict[int, bool], dict[int, CrossSection]]:
    """The roads that are made one-way, True from start to end, and all sections.

    A road of a ring that is one-way already keeps its direction.
    """
    rings, found = {}, dict(sections)
    for edge, forward in directions.items():
        section = sections[edge]
        found[edge] = one_way(section, forward)
        rings[edge] = bool(found[edge].driving_ids("forward"))
    return rings, found


def direction_of(section: CrossSection) -> Literal["forward", "backward"] | None:
    """In which all lanes for motor vehicles run; None where they do not run one way."""
    directions = {lane.direction for lane in section.lanes if lane.drivable}
    if directions == {"forward"}:
        return "forward"
    return "backward" if directions == {"backward"} else None


def one_way(section: CrossSection, forward: bool) -> CrossSection:
    """All lanes for motor vehicles run forward, or backward, unless they run one way already."""
    if direction_of(section) is not None:
        return section
    lanes = tuple(
        replace(lane, direction="forward" if forward else "backward") if lane.drivable else lane
        for lane in section.lanes
    )
    marking = "broken" if section.center_marking == "double" else section.center_marking
    return replace(section, lanes=lanes, center_marking=marking)
