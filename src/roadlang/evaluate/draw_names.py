"""The names of draws: their place, with the number of the road or copy where there are several."""

from __future__ import annotations

import re
from functools import lru_cache

_ELEMENT = re.compile(r"\[\d+\]$")


def coordinate_name(place: str, element: int) -> str:
    """`bent/perturb 1/amplitude`; with the number of the road or copy where there are several."""
    return f"{place}[{element}]" if element else place


@lru_cache(maxsize=256)
def coordinate_names(place: str, elements: tuple[int, ...]) -> tuple[str, ...]:
    """The names of the draws of several roads or copies at a place."""
    return tuple([coordinate_name(place, element) for element in elements])


@lru_cache(maxsize=16384)
def draw_place(name: str) -> str:
    """The place of the draw that `coordinate_name` gave this name."""
    return _ELEMENT.sub("", name) if name.endswith("]") else name
