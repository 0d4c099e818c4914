"""Where along the roads each satisfied constraint is nearest to being violated."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import palette
from .labels import PixelBox
from .markup import element, group, rho, text, title
from .wrapping import LETTER

if TYPE_CHECKING:
    from roadlang.api import Scene, Verdict

    from .ribbon import Ribbon

_CLOSE = 34.0
"""Pixels under which two places share one mark."""
_LENGTHS = (1.1, 2.3, 3.5)
"""Font sizes, of pins: the first whose name is clear of what else is written"""
_NAME_SIZE = 0.85
"""Font sizes, of the names"""


def tight_places(
    scene: Scene, ribbons: Mapping[str, Ribbon], size: float, taken: Sequence[PixelBox] = ()
) -> str:
    """A pin beside the road at each place, with the names of the constraints that are tight: long
    enough that the names are clear of what is `taken`, where that is possible."""
    verdicts = [
        verdict
        for verdict in (*scene.requirements, *scene.expectations)
        if verdict.satisfied and verdict.tightest and verdict.tightest.road in ribbons
    ]
    return group(
        _pins(verdicts, ribbons, size, taken),
        class_="tightest",
        font_size=_NAME_SIZE * size,
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


def _pins(
    verdicts: Sequence[Verdict],
    ribbons: Mapping[str, Ribbon],
    size: float,
    taken: Sequence[PixelBox],
) -> Iterator[str]:
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
        yield from _drawn(pin, size, taken)


def _pin_of(verdict: Verdict, ribbons: Mapping[str, Ribbon]) -> Pin | None:
    place = verdict.tightest
    assert place is not None
    part = ribbons[place.road].part(place.station, place.station + 1e-3, by_reference=True)
    away = part.left[0]
    x, y = (part.line(1.0)[0] + 3.0 * away).tolist()
    dx, dy = away.tolist()
    return Pin(x, y, dx, dy, [verdict]) if math.isfinite(x + y) else None


def _drawn(pin: Pin, size: float, taken: Sequence[PixelBox]) -> Iterator[str]:
    hint = "; ".join(
        f"{verdict.name} is tightest here: {rho(verdict.robustness)}"
        for verdict in pin.verdicts
        if verdict.robustness is not None
    )
    label = ", ".join(verdict.name for verdict in pin.verdicts)
    anchor = "start" if pin.dx > 0.35 else "end" if pin.dx < -0.35 else "middle"
    heads = [(pin.x + long * size * pin.dx, pin.y + long * size * pin.dy) for long in _LENGTHS]
    clear = (
        head
        for head in heads
        if not any(_name_box(pin, head, label, size).overlaps(box) for box in taken)
    )
    x, y = next(clear, heads[0])
    line = {"stroke": palette.TIGHT, "stroke_width": 1.2}
    yield element(
        "g",
        title(hint),
        element("line", x1=pin.x, y1=pin.y, x2=x, y2=y, **line),
        element("circle", cx=pin.x, cy=pin.y, r=0.24 * size, stroke=palette.TIGHT),
    )
    yield text(label, x + 0.25 * size * pin.dx, y + _below(pin, size), text_anchor=anchor)


def _name_box(pin: Pin, head: tuple[float, float], label: str, size: float) -> PixelBox:
    """What the name takes up with the head of its pin there."""
    wide = LETTER * _NAME_SIZE * size * len(label)
    aside = 0.5 if pin.dx > 0.35 else -0.5 if pin.dx < -0.35 else 0.0
    x = head[0] + 0.25 * size * pin.dx + aside * wide
    return PixelBox.around(x, head[1] + _below(pin, size), wide, _NAME_SIZE * size)


def _below(pin: Pin, size: float) -> float:
    """Pixels from the head of a pin down to the baseline of its name."""
    return 0.75 * size if pin.dy > 0.35 else -0.15 * size if pin.dy < -0.35 else 0.3 * size
