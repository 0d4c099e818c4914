"""Which lanes lie left of the reference line: in OpenDRIVE the side of a lane is its direction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from roadlang.geometry import CrossSection, Lane


@dataclass(frozen=True)
class LaneNumbers:
    """The first `left` lanes from the left lie left of the reference line; new ids by those of the
    scene. `contrary`: scene ids of lanes that run against their side."""

    left: int
    ids: Mapping[int, int]
    contrary: frozenset[int]


def lane_numbers(section: CrossSection, left_hand: bool) -> LaneNumbers:
    """Numbers by which every drivable lane runs as its side says, where there are any.

    In right-hand traffic lanes on the right run along the road; in left-hand traffic against it.
    Of several ways to part the lanes, the one nearest to the ids of the scene.
    """
    lanes = section.lanes
    written = sum(lane.id > 0 for lane in lanes)
    parted = sorted(range(len(lanes) + 1), key=lambda left: (abs(left - written), left))
    left = next((k for k in parted if not _contrary(lanes, k, left_hand)), written)
    ids = {
        lane.id: left - place if place < left else left - place - 1
        for place, lane in enumerate(lanes)
    }
    return LaneNumbers(left, ids, frozenset(_contrary(lanes, left, left_hand)))


def _contrary(lanes: tuple[Lane, ...], left: int, left_hand: bool) -> list[int]:
    found = []
    for place, lane in enumerate(lanes):
        along = (place < left) == left_hand
        one_way = lane.drivable and lane.direction in ("forward", "backward")
        if one_way and (lane.direction == "forward") != along:
            found.append(lane.id)
    return found
