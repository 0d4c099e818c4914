"""`choice(a, b, weights: [3, 1])`: one of several."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Anything, Distribution, Number, list_of, option


@dataclass(frozen=True)
class Choice(Distribution):
    """One of the values, by weight."""

    name: ClassVar[str] = "choice"
    rest: ClassVar[str] = "items"
    items: list_of(Anything, at_least=1) = option(help="the values to choose from")
    weights: list_of(Number) = option(None, help="how likely each is, relative to the others")
