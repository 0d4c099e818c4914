"""`integer(a, b)`: a whole number."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Distribution, Whole, option


@dataclass(frozen=True)
class Integer(Distribution):
    """A whole number from `low` to `high`, both included, each as likely."""

    name: ClassVar[str] = "integer"
    low: Whole = option(help="the least")
    high: Whole = option(help="the greatest")
