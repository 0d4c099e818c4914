"""The lanes of a path through a network whose roads have their own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..curves.profile import OffsetProfile
from ..curves.width import WidthProfile
from ..lanes.cross_section import CrossSection
from .paths import Path, Step

_INSIDE = 1e-6


def section_of_path(path: Path) -> CrossSection | None:
    """The cross-section along `path.curve`; None where some road of it has none of its own.

    Where the roads have the same lanes, widths and offsets are those of each. Where they do not,
    the lanes are those of the longest part, and the drivable ones share the width of the path.
    """
    sections = [_seen_from(path, step) for step in path.steps]
    if any(section is None for section in sections):
        return None
    found = [section for section in sections if section is not None]
    if len({_shape(section) for section in found}) == 1:
        return _joined(path, found)
    lengths = [step.length for step in path.steps]
    longest = lengths.index(max(lengths))
    step, section = path.steps[longest], found[longest]
    middle = (step.start + step.stop) / 2.0
    s = middle if step.stop >= step.start else path.network.edge(step.edge).length - middle
    lanes = tuple(
        replace(lane, width=WidthProfile.constant(max(float(lane.width.at(s)), _INSIDE)))
        for lane in section.lanes
    )
    return CrossSection(lanes, section.center_marking).scaled_to(path.width)


def _seen_from(path: Path, step: Step) -> CrossSection | None:
    """The lanes of the road of a step, by arc length in the direction of the step."""
    edge = path.network.edge(step.edge)
    if edge.cross_section is None or step.stop >= step.start:
        return edge.cross_section
    return edge.cross_section.reversed(edge.length)


def _shape(section: CrossSection) -> tuple[object, ...]:
    lanes = ((lane.id, lane.kind, lane.direction, lane.drivable) for lane in section.lanes)
    return (section.center_offset is None, *lanes)


def _joined(path: Path, sections: list[CrossSection]) -> CrossSection:
    if path.is_loop:
        return sections[0]
    stations, places, traveled = [], [], 0.0
    for step in path.steps:
        edge = path.network.edge(step.edge)
        begin = step.start if step.stop >= step.start else edge.length - step.start
        along = np.linspace(0.0, step.length, max(2, int(step.length) + 1))
        # A hair inside, where the next step may begin with other widths.
        inside = np.clip(along, _INSIDE * step.length, (1.0 - _INSIDE) * step.length)
        stations.append(traveled + inside)
        places.append(begin + along)
        traveled += step.length
    s = np.concatenate(stations) * (path.curve.length / traveled)
    parts = list(zip(sections, places, strict=True))
    lanes = tuple(
        replace(
            lane,
            width=WidthProfile(
                s, np.concatenate([part.lanes[index].width.at(at) for part, at in parts])
            ),
        )
        for index, lane in enumerate(sections[0].lanes)
    )
    offset = None
    if all(part.center_offset is not None for part in sections):
        offsets = [part.center_offset.at(at) for part, at in parts if part.center_offset]
        offset = OffsetProfile(s, np.concatenate(offsets))
    return replace(sections[0], lanes=lanes, center_offset=offset)
