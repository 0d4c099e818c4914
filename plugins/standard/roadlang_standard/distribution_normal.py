"""`normal(mean, sd)`: the bell curve, cut off where wanted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Between, Distribution, Like, option


@dataclass(frozen=True)
class Normal(Distribution):
    """A normal distribution, truncated to `within` where given."""

    name: ClassVar[str] = "normal"
    mean: Like = option(help="the middle")
    sd: Like = option(help="standard deviation; not negative")
    within: Between = option(None, help="`[least, greatest]`: never beyond")
