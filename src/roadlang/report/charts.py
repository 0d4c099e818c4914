"""Charts that do not move: how a search went, and what was covered."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..falsification.statistics import Coverage
from ..geometry.arrays import Floats
from .elements import drawing, element, text
from .numbers import number, quantity

Place = Callable[[Floats, Floats], tuple[Floats, Floats]]
_WIDE, _TALL = 360.0, 190.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 44.0, 8.0, 10.0, 34.0
_QUANTILES = (0.01, 0.99)
_MARGIN = 0.08
UNITS = {"curvature": "1/m", "speed": "m/s", "gap": "m"}
TITLES = {
    "curvature": "Greatest curvature",
    "speed": "Greatest speed",
    "gap": "Smallest gap to others",
}


def progress_chart(
    numbers: Sequence[int],
    robustness: Sequence[float],
    failed: Sequence[bool],
    best: Sequence[tuple[int, float]],
    unit: str,
) -> str:
    """The robustness of every drive in the order of evaluation, and the least so far as a line."""
    x, y = np.array(numbers, dtype=float), np.array(robustness, dtype=float)
    failing = np.array(failed, dtype=bool)
    if not len(x):
        return ""
    low, high = min(float(y.min()), 0.0), float(np.quantile(y, _QUANTILES[1]))
    room = _MARGIN * max(high - low, 1e-9)
    low, high = low - room, max(high, 0.0) + room
    end = max(float(x.max()), 1.0)

    def place(px: Floats, py: Floats) -> tuple[Floats, Floats]:
        across = _LEFT + px / end * (_WIDE - _LEFT - _RIGHT)
        up = (np.clip(py, low, high) - low) / (high - low)
        return across, _TALL - _BOTTOM - up * (_TALL - _TOP - _BOTTOM)

    zero = float(place(np.zeros(1), np.zeros(1))[1][0])
    parts = [
        element("path", d=f"M{_LEFT} {zero:.1f}H{_WIDE - _RIGHT}", class_="zero"),
        element("path", d=_dots(*place(x[~failing], y[~failing])), class_="dots safe"),
        element("path", d=_dots(*place(x[failing], y[failing])), class_="dots failed"),
    ]
    if best:
        steps = np.array(best, dtype=float)
        bx, by = place(steps[:, 0], steps[:, 1])
        line = f"M{bx[0]:.1f} {by[0]:.1f}" + "".join(
            f"H{a:.1f}V{b:.1f}" for a, b in zip(bx[1:], by[1:], strict=True)
        )
        parts.append(element("path", d=f"{line}H{_WIDE - _RIGHT}", class_="best"))
    parts += _y_labels([(low + room, None), (0.0, "0"), (high - room, None)], place, unit)
    parts += _x_labels(((0.0, "0"), (end, number(end, 6))), place, "evaluation")
    return _svg(parts, "Robustness of each drive in the order of evaluation")


def coverage_chart(name: str, found: Coverage, unit: str) -> str:
    """How many drives, and how many of them failing, in equal parts of a measure."""
    most = max(found.scenes)
    step = (_WIDE - _LEFT - _RIGHT) / len(found.scenes)
    tall = _TALL - _TOP - _BOTTOM
    parts = []
    for index, (scenes, failures) in enumerate(zip(found.scenes, found.failures, strict=True)):
        for count, kind in ((scenes, "safe"), (failures, "failed")):
            if count:
                up = max(tall * count / most, 1.0)
                x, y = _LEFT + index * step, _TALL - _BOTTOM - up
                bar = {"x": f"{x + 1:.1f}", "width": f"{step - 2:.1f}"}
                parts.append(
                    element("rect", y=f"{y:.1f}", height=f"{up:.1f}", class_=f"bar {kind}", **bar)
                )
    base = _TALL - _BOTTOM
    parts += [
        element("path", d=f"M{_LEFT} {base}H{_WIDE - _RIGHT}", class_="zero"),
        _label(number(most, 6), _LEFT - 6, _TOP + 9, "end"),
        _label(quantity(found.low, unit), _LEFT, base + 15, "start"),
        _label(quantity(found.high, unit), _WIDE - _RIGHT, base + 15, "end"),
    ]
    return _svg(parts, f"{TITLES.get(name, name)} of the drives")


def _dots(x: Floats, y: Floats) -> str:
    return "".join(f"M{a:.1f} {b:.1f}h0" for a, b in zip(x.tolist(), y.tolist(), strict=True))


def _y_labels(ticks: Sequence[tuple[float, str | None]], place: Place, unit: str) -> list[str]:
    shown: list[tuple[float, str]] = []
    for value, words in sorted(ticks, key=lambda tick: tick[1] is None):
        up = float(place(np.zeros(1), np.array([value]))[1][0])
        if all(abs(up - other) > 14 for other, _ in shown):
            shown.append((up, words or quantity(value, unit, 2)))
    return [_label(words, _LEFT - 6, up + 4, "end") for up, words in shown]


def _x_labels(ticks: Sequence[tuple[float, str]], place: Place, title: str) -> list[str]:
    base = _TALL - _BOTTOM + 15
    across = [float(place(np.array([value]), np.zeros(1))[0][0]) for value, _ in ticks]
    anchors = ["start", *["middle"] * (len(ticks) - 2), "end"]
    labels = [
        _label(words, x, base, anchor)
        for (_, words), x, anchor in zip(ticks, across, anchors, strict=True)
    ]
    return [*labels, _label(title, (_LEFT + _WIDE - _RIGHT) / 2, base + 14, "middle")]


def _label(words: str, x: float, y: float, anchor: str) -> str:
    return element("text", text(words), x=f"{x:.1f}", y=f"{y:.1f}", text_anchor=anchor)


def _svg(parts: Sequence[str], label: str) -> str:
    box = f"0 0 {_WIDE:.0f} {_TALL:.0f}"
    return drawing(*parts, viewBox=box, role="img", aria_label=label, class_="chart")
