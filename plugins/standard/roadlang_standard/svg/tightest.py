"""Where along the roads each judged requirement has its least robustness."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, rho, text, title

if TYPE_CHECKING:
    from roadlang.api import Scene, Verdict

    from .ribbon import Ribbon

_CLOSE = 34.0
"""Pixels under which two places share one mark."""


@dataclass(frozen=True)
class Tightest:
    """`station` is arc length of the root road, meters."""

    name: str
    road: str
    station: float
    robustness: float


def tightest(verdict: Verdict) -> Tightest | None:
    """The place of the least robustness along all roads; None for what has no profile."""
    found = [
        Tightest(verdict.name, profile.road, station, value)
        for profile in verdict.profiles
        for station, value in zip(profile.stations, profile.values, strict=True)
    ]
    return min(found, key=lambda place: place.robustness, default=None)


def tight_places(scene: Scene, ribbons: Mapping[str, Ribbon], size: float) -> str:
    """A pin beside the road at each place, with the names of the constraints that are tight."""
    verdicts = (*scene.requirements, *scene.expectations)
    satisfied = [verdict for verdict in verdicts if verdict.satisfied]
    places = [place for place in map(tightest, satisfied) if place and place.road in ribbons]
    return group(
        _pins(places, ribbons, size),
        class_="tightest",
        font_size=0.85 * size,
        fill=palette.TIGHT,
        paint_order="stroke",
        stroke=palette.GROUND,
        stroke_width=2.6,
        stroke_linejoin="round",
    )


def _pins(places: list[Tightest], ribbons: Mapping[str, Ribbon], size: float) -> Iterator[str]:
    import numpy as np

    pins: list[tuple[float, float, float, float, list[Tightest]]] = []
    for place in places:
        ribbon = ribbons[place.road]
        part = ribbon.part(place.station, place.station + 1e-3, by_reference=True)
        foot = part.line(1.0)[0] + 3.0 * part.left[0]
        out = part.left[0]
        if not np.isfinite(foot).all():
            continue
        near = [pin for pin in pins if np.hypot(pin[0] - foot[0], pin[1] - foot[1]) < _CLOSE]
        if near:
            near[0][4].append(place)
        else:
            pins.append((*foot.tolist(), *out.tolist(), [place]))
    for x, y, dx, dy, together in pins:
        yield from _pin(x, y, dx, dy, together, size)


def _pin(
    x: float, y: float, dx: float, dy: float, places: list[Tightest], size: float
) -> Iterator[str]:
    hint = "; ".join(f"{p.name} is tightest here: {rho(p.robustness)}" for p in places)
    end = (x + 1.1 * size * dx, y + 1.1 * size * dy)
    yield element(
        "g",
        title(hint),
        element("line", x1=x, y1=y, x2=end[0], y2=end[1], stroke=palette.TIGHT, stroke_width=1.2),
        element("circle", cx=x, cy=y, r=0.24 * size, stroke=palette.TIGHT, stroke_width=1.0),
    )
    anchor = "start" if dx > 0.35 else "end" if dx < -0.35 else "middle"
    below = 0.75 * size if dy > 0.35 else -0.15 * size if dy < -0.35 else 0.3 * size
    label = ", ".join(place.name for place in places)
    yield text(label, end[0] + 0.25 * size * dx, end[1] + below, text_anchor=anchor)
