"""Cubics along roads: read from a file, and evaluated."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from roadlang_formats.map_xml import MapElement, MapFile

from .records import Cubic

if TYPE_CHECKING:
    from roadlang.geometry import Floats

_MOST_STEPS = 400
"""Of one cubic."""


def cubics(file: MapFile, elements: Iterable[MapElement], start: str) -> tuple[Cubic, ...]:
    """The cubics of elements, by their `start` attribute, in which they must be written."""
    found: list[Cubic] = []
    for element in elements:
        at = file.number(element, start)
        if found and at < found[-1].start:
            raise file.fault(element, f"this `{element.tag}` begins before the one above it")
        numbers = (file.number(element, name, 0.0) for name in "abcd")
        found.append(Cubic(at, *numbers))
    return tuple(found)


def value_at(cubics: Sequence[Cubic], s: Floats) -> Floats:
    """(n,) at `s` (n,), by the last cubic that has begun; zero without any."""
    import numpy as np

    if not cubics:
        return np.zeros_like(s)
    starts = np.array([cubic.start for cubic in cubics])
    table = np.array([(cubic.a, cubic.b, cubic.c, cubic.d) for cubic in cubics])
    place = np.maximum(np.searchsorted(starts, s + 1e-9, side="right") - 1, 0)
    t = np.maximum(s - starts[place], 0.0)
    a, b, c, d = table[place].T
    return np.asarray(a + t * (b + t * (c + t * d)))


def knots(cubics: Sequence[Cubic], length: float, tolerance: float) -> list[float]:
    """Stations in [0, length] between which lines are within `tolerance` of the cubics. Where one
    begins there is a station just before it as well."""
    found: list[float] = []
    stops = [*(cubic.start for cubic in cubics[1:]), length]
    for cubic, after in zip(cubics, stops, strict=False):
        start, stop = max(cubic.start, 0.0), min(after, length)
        if stop <= start:
            continue
        span = stop - start
        bend = max(abs(2.0 * cubic.c), abs(2.0 * cubic.c + 6.0 * cubic.d * span))
        steps = min(max(1, int((bend / (8.0 * tolerance)) ** 0.5 * span) + 1), _MOST_STEPS)
        found += [start + span * step / steps for step in range(steps)]
        found.append(stop)
    return found
