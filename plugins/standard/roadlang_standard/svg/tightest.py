"""Where along the roads each satisfied constraint is nearest to being violated."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, rho, text, title

if TYPE_CHECKING:
    from roadlang.api import Scene, Verdict

    from .ribbon import Ribbon

_CLOSE = 34.0
"""Pixels under which two places share one mark."""


def tight_places(scene: Scene, ribbons: Mapping[str, Ribbon], size: float) -> str:
    """A pin beside the road at each place, with the names of the constraints that are tight."""
    verdicts = [
        verdict
        for verdict in (*scene.requirements, *scene.expectations)
        if verdict.satisfied and verdict.tightest and verdict.tightest.road in ribbons
    ]
    return group(
        _pins(verdicts, ribbons, size),
        class_="tightest",
        font_size=0.85 * size,
        fill=palette.TIGHT,
        paint_order="stroke",
        stroke=palette.GROUND,
        stroke_width=2.6,
        stroke_linejoin="round",
    )


@dataclass(frozen=True)
class Pin:
    """Pixels: its foot (`x`, `y`) at the road's left edge, (`dx`, `dy`) away from the road."""

    x: float
    y: float
    dx: float
    dy: float
    verdicts: list[Verdict]


def _pins(verdicts: Sequence[Verdict], ribbons: Mapping[str, Ribbon], size: float) -> Iterator[str]:
    pins: list[Pin] = []
    for verdict in verdicts:
        pin = _pin_of(verdict, ribbons)
        if pin is None:
            continue
        near = [p for p in pins if math.hypot(p.x - pin.x, p.y - pin.y) < _CLOSE]
        if near:
            near[0].verdicts.append(verdict)
        else:
            pins.append(pin)
    for pin in pins:
        yield from _drawn(pin, size)


def _pin_of(verdict: Verdict, ribbons: Mapping[str, Ribbon]) -> Pin | None:
    place = verdict.tightest
    assert place is not None
    part = ribbons[place.road].part(place.station, place.station + 1e-3, by_reference=True)
    away = part.left[0]
    x, y = (part.line(1.0)[0] + 3.0 * away).tolist()
    dx, dy = away.tolist()
    return Pin(x, y, dx, dy, [verdict]) if math.isfinite(x + y) else None


def _drawn(pin: Pin, size: float) -> Iterator[str]:
    hint = "; ".join(
        f"{verdict.name} is tightest here: {rho(verdict.robustness)}"
        for verdict in pin.verdicts
        if verdict.robustness is not None
    )
    x, y = pin.x + 1.1 * size * pin.dx, pin.y + 1.1 * size * pin.dy
    line = {"stroke": palette.TIGHT, "stroke_width": 1.2}
    yield element(
        "g",
        title(hint),
        element("line", x1=pin.x, y1=pin.y, x2=x, y2=y, **line),
        element("circle", cx=pin.x, cy=pin.y, r=0.24 * size, stroke=palette.TIGHT),
    )
    anchor = "start" if pin.dx > 0.35 else "end" if pin.dx < -0.35 else "middle"
    below = 0.75 * size if pin.dy > 0.35 else -0.15 * size if pin.dy < -0.35 else 0.3 * size
    label = ", ".join(verdict.name for verdict in pin.verdicts)
    yield text(label, x + 0.25 * size * pin.dx, y + below, text_anchor=anchor)
