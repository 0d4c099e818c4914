"""Between the cross-section of a road and the numbers of a scene."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..geometry import CrossSection, Lane, OffsetProfile, WidthProfile
from ..geometry.arrays import Floats
from .scene_lane import SceneLane

if TYPE_CHECKING:
    from ..geometry.lanes.lanes import Marking


def equal_lanes(
    count: int, stations: tuple[float, ...], width: tuple[float, ...], period: float | None
) -> CrossSection:
    """The lanes of a scene that does not list them."""
    profile = WidthProfile(np.array(stations), np.array(width), period)
    return CrossSection.of_lane_count(count, profile)


def listed_lanes(
    listed: tuple[SceneLane, ...],
    center_marking: Marking,
    center_offset: tuple[float, ...],
    stations: tuple[float, ...],
    period: float | None,
) -> CrossSection:
    """The lanes that a scene lists. Raises GeometryError for impossible ones."""
    lanes = tuple(
        Lane(
            lane.id,
            lane.kind,
            WidthProfile(*_profile(stations, lane.width), period),
            lane.direction,
            lane.drivable,
            lane.speed_limit,
            lane.marking,
            lane.users,
            lane.raised,
        )
        for lane in listed
    )
    offset = None
    if center_offset:
        offset = OffsetProfile(*_profile(stations, center_offset), period)
    return CrossSection(lanes, center_marking, offset)


def _profile(stations: tuple[float, ...], values: tuple[float, ...]) -> tuple[Floats, Floats]:
    """One number is for all of the road."""
    places = np.array(stations) if len(values) > 1 else np.zeros(1)
    return places, np.array(values)
