"""`a..b`, or `uniform(a, b)`: every value between two is as likely."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Distribution, Like, option


@dataclass(frozen=True)
class Uniform(Distribution):
    """Any number between two, each as likely."""

    name: ClassVar[str] = "uniform"
    low: Like = option(help="the least")
    high: Like = option(help="the greatest")
