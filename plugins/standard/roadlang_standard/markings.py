"""Kinds of objects that are paint on the road."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Length, ObjectKind, option


@dataclass(frozen=True)
class Crosswalk(ObjectKind):
    """A zebra crossing, a crosswalk without signals, at which `traffic` yields."""

    name: ClassVar[str] = "crosswalk"
    category: ClassVar[str] = "crosswalk"
    length: Length = option(4.0, above=0, maximum=50, help="dimension along the road")
    width: Length = option(
        None,
        above=0,
        maximum=500,
        help="dimension across the road; by default from curb to curb, without a road 7m",
        example="6.5m",
    )
