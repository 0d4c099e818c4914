"""The lanes of a way by its tags, counted as netconvert does."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

from ..speed_units import KMH, MPH
from .implied_limits import implied_limit

Tags = Mapping[str, str]

LANES: Mapping[str, int] = {
    "motorway": 2,
    "trunk": 2,
    "primary": 2,
    **dict.fromkeys(
        (
            "secondary",
            "tertiary",
            "unclassified",
            "residential",
            "living_street",
            "service",
            "road",
            "motorway_link",
            "trunk_link",
            "primary_link",
            "secondary_link",
            "tertiary_link",
        ),
        1,
    ),
}
"""The ways for motor vehicles, and their default number of lanes in each direction."""
_MOST = 12
_UNITS = {"": KMH, "km/h": KMH, "kmh": KMH, "kph": KMH, "mph": MPH}
_IMPLIED = ("maxspeed:type", "source:maxspeed", "zone:maxspeed", "zone:traffic")
"""The tags that may have a limit where `maxspeed` is missing; the first that has one counts."""
_ONE_WAY = {"yes": True, "true": True, "1": True, "-1": False, "reverse": False}


@dataclass(frozen=True, slots=True)
class WayLanes:
    """How many lanes run along a way and against it, and the speed limit of each direction in
    m/s, None without one."""

    forward: int
    backward: int
    forward_limit: float | None
    backward_limit: float | None

    @property
    def is_symmetric(self) -> bool:
        """Whether both directions are alike, so that the way may be read against its own."""
        return (self.forward, self.forward_limit) == (self.backward, self.backward_limit)


def is_driven(tags: Tags) -> bool:
    """Whether motor vehicles may use a way; areas do not count."""
    return (
        tags.get("highway") in LANES
        and tags.get("area") != "yes"
        and tags.get("access") not in ("no",)
        and tags.get("motor_vehicle") != "no"
    )


def one_way(tags: Tags) -> bool | None:
    """True for one-way traffic along the way, False against it, None for both ways."""
    written = tags.get("oneway", "")
    if written in _ONE_WAY:
        return _ONE_WAY[written]
    implied = tags.get("junction") in ("roundabout", "circular")
    implied = implied or tags.get("highway") in ("motorway", "motorway_link")
    return True if implied and written != "no" else None


def level_of(tags: Tags) -> int:
    """`layer`; without it 1 on bridges, -1 in tunnels, and 0 on the ground."""
    usual = int(tags.get("bridge", "no") != "no") - int(tags.get("tunnel", "no") != "no")
    written = tags.get("layer", "")
    return int(written) if re.fullmatch(r"-?\d", written) else usual


def way_lanes(tags: Tags) -> WayLanes:
    """From `lanes`, `lanes:forward` and `lanes:backward`; with an odd number, the extra lane runs
    forward."""
    usual = LANES[tags["highway"]]
    total, forward, backward = (
        _count(tags.get(name)) for name in ("lanes", "lanes:forward", "lanes:backward")
    )
    limits = _limit(tags, "forward"), _limit(tags, "backward")
    way = one_way(tags)
    if way is not None:
        count = total or (forward if way else backward) or usual
        return WayLanes(count if way else 0, 0 if way else count, *limits)
    if total is not None:
        if forward is None:
            forward = total - backward if backward is not None else math.ceil(total / 2)
        if backward is None:
            backward = total - forward
    return WayLanes(
        max(usual if forward is None else forward, 1),
        max(usual if backward is None else backward, 1),
        *limits,
    )


def _count(written: str | None) -> int | None:
    found = re.match(r"\d{1,3}(?=\D|$)", (written or "").strip())
    return min(int(found.group()), _MOST) if found and int(found.group()) else None


def _limit(tags: Tags, direction: str) -> float | None:
    """That of the direction, or of both, or what other tags imply."""
    for name in (f"maxspeed:{direction}", "maxspeed"):
        if name in tags:
            return speed_limit(tags[name])
    implied = (speed_limit(tags[name]) for name in _IMPLIED if name in tags)
    return next((limit for limit in implied if limit is not None), None)


def speed_limit(written: str) -> float | None:
    """m/s, of a number or a word such as `DE:urban`; None where there is none, as `signals`."""
    found = re.fullmatch(r"\s*(\d{1,3}(?:\.\d+)?)\s*([a-z/]*)\s*", written)
    if found is None:
        return implied_limit(written.strip())
    if found.group(2) not in _UNITS or not float(found.group(1)):
        return None
    return float(found.group(1)) * _UNITS[found.group(2)]
