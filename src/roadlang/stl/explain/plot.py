"""A plot of a verdict as SVG: the robustness, the signals, and the intervals to blame."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from html import escape

import numpy as np

from ..evaluate.evaluation import everywhere
from ..evaluate.trace import FloatArray, Positions, SampledSignals, Signals
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.terms import number_text
from .explanation import Explanation, explain

_WIDTH, _PANEL, _GAP = 860, 130, 44
_LEFT, _RIGHT, _TOP = 74, 24, 76
_COLORS = ("#1b6ca8", "#b0562b", "#3f7d43", "#7a4fa3", "#8a6d1a", "#3b7f86")
_BLAME, _INK, _FAINT = "#c62f3d", "#222", "#d9d9d9"
_MOST_POINTS = 2000


def plot_svg(
    formula: f.Formula,
    positions: Positions,
    signals: Signals,
    *,
    axis: str = "position",
    variant: int = 0,
    wrap: float | None = None,
) -> str:
    """A stand-alone SVG picture of one variant: panels over `axis`, the first one the robustness.

    Samples at which a needed comparison fails are shaded in its signals' panels; thresholds that
    are constants are dashed lines; a dot marks the sample that decides.
    """
    why = explain(formula, positions, signals, variant=variant, wrap=wrap)
    trace = SampledSignals.of(positions, signals, formula.variables, wrap).alone(variant)
    names = sorted(formula.variables)
    height = _TOP + (1 + len(names)) * (_PANEL + _GAP) + 22
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height}"'
        f' width="{_WIDTH}" height="{height}" font-family="sans-serif" font-size="12"'
        f' fill="{_INK}">',
        f'<rect width="{_WIDTH}" height="{height}" fill="white"/>',
        f'<text x="{_LEFT}" y="24" font-size="14" font-weight="bold">'
        f"{escape(_shortened(str(formula)))}</text>",
        f'<text x="{_LEFT}" y="44">{escape(why.lines()[0])}</text>',
    ]
    panels = [_robustness_panel(formula, trace, why)]
    panels += [_signal_panel(formula, trace, why, name, k) for k, name in enumerate(names)]
    for index, panel in enumerate(panels):
        parts += panel.draw(_TOP + index * (_PANEL + _GAP))
    middle = (_LEFT + _WIDTH - _RIGHT) / 2
    parts.append(f'<text x="{middle}" y="{height - 6}" text-anchor="middle">{escape(axis)}</text>')
    return "\n".join([*parts, "</svg>", ""])


class _Panel:
    """One curve over the positions, with lines, shaded intervals and a dot."""

    def __init__(self, title: str, color: str, x: FloatArray, y: FloatArray) -> None:
        self.title, self.color, self.x, self.y = title, color, x, y
        self.levels: dict[float, str] = {}
        self.shaded: list[tuple[float, float]] = []
        self.dot: tuple[float, float] | None = None

    def draw(self, top: float) -> Iterator[str]:
        """SVG elements of the panel with its upper edge at `top`."""
        finite = self.y[np.isfinite(self.y)]
        shown = [*finite.tolist(), *self.levels] or [0.0]
        low, high = _padded(min(shown), max(shown))
        first, last = _padded(float(self.x[0]), float(self.x[-1]), 0.0)

        def across(x: float) -> float:
            return _LEFT + (x - first) / (last - first) * (_WIDTH - _LEFT - _RIGHT)

        def down(y: float) -> float:
            return top + _PANEL - (min(max(y, low), high) - low) / (high - low) * _PANEL

        for start, end in self.shaded:
            left, right = across(start), across(end)
            width = max(right - left, 2.0)
            yield (
                f'<rect class="violated" x="{left:.1f}" y="{top}" width="{width:.1f}"'
                f' height="{_PANEL}" fill="{_BLAME}" fill-opacity="0.16"/>'
            )
        yield from _grid(top, across, down, (first, last), (low, high))
        for level, label in self.levels.items():
            y = down(level)
            yield (
                f'<path d="M{_LEFT} {y:.1f}H{_WIDTH - _RIGHT}" stroke="{_INK}"'
                f' stroke-dasharray="5 4" stroke-width="0.8"/>'
                f'<text x="{_WIDTH - _RIGHT - 4}" y="{y - 4:.1f}" text-anchor="end"'
                f' font-size="10">{escape(label)}</text>'
            )
        for run in _runs(self.x, self.y):
            points = " ".join(f"{across(x):.1f},{down(y):.1f}" for x, y in run)
            yield (
                f'<polyline points="{points}" fill="none" stroke="{self.color}"'
                f' stroke-width="1.6"/>'
            )
        if self.dot is not None:
            x, y = self.dot
            yield f'<circle cx="{across(x):.1f}" cy="{down(y):.1f}" r="4" fill="{_BLAME}"/>'
        yield f'<text x="{_LEFT}" y="{top - 6}" fill="{self.color}">{escape(self.title)}</text>'


def _robustness_panel(formula: f.Formula, trace: SampledSignals, why: Explanation) -> _Panel:
    """Of `always p` and `eventually p`, the robustness of p says where: that is drawn."""
    ahead = isinstance(formula, f.UnaryTemporal) and not formula.past
    shown = formula.parts[0] if ahead else formula
    title = f"robustness of {_shortened(str(shown))}" if ahead else "robustness"
    panel = _Panel(title, _INK, trace.positions, everywhere(shown, trace)[0])
    panel.levels = {0.0: ""}
    panel.shaded = [(interval.start, interval.end) for interval in why.stretches]
    return panel


def _signal_panel(
    formula: f.Formula, trace: SampledSignals, why: Explanation, name: str, index: int
) -> _Panel:
    values = np.broadcast_to(trace.rows(name, 0, 1)[0], (trace.samples,))
    panel = _Panel(name, _COLORS[index % len(_COLORS)], trace.positions, values)
    panel.levels = dict(_thresholds(formula, name))
    panel.shaded = [
        (interval.start, interval.end) for interval in why.stretches if name in interval.signals
    ]
    if name in why.values:
        panel.dot = (why.position, why.values[name])
    return panel


def _comparisons(formula: f.Formula) -> Iterator[f.Comparison]:
    return (part for part in formula.walk() if isinstance(part, f.Comparison))


def _thresholds(formula: f.Formula, name: str) -> Iterator[tuple[float, str]]:
    for comparison in _comparisons(formula):
        sides = (comparison.left, comparison.right)
        for term, bound in (sides, sides[::-1]):
            if not isinstance(bound, t.Constant):
                continue
            if term == t.Variable(name):
                yield bound.value, str(comparison)
            elif term == t.Apply("abs", (t.Variable(name),)):
                yield bound.value, str(comparison)
                yield -bound.value, str(comparison)


def _grid(
    top: float,
    across: object,
    down: object,
    horizontal: tuple[float, float],
    vertical: tuple[float, float],
) -> Iterator[str]:
    assert callable(across)
    assert callable(down)
    for x in _ticks(*horizontal, 8):
        yield (
            f'<path d="M{across(x):.1f} {top}v{_PANEL}" stroke="{_FAINT}" stroke-width="0.6"/>'
            f'<text x="{across(x):.1f}" y="{top + _PANEL + 14}" text-anchor="middle"'
            f' font-size="10">{number_text(x)}</text>'
        )
    for y in _ticks(*vertical, 4):
        yield (
            f'<path d="M{_LEFT} {down(y):.1f}H{_WIDTH - _RIGHT}" stroke="{_FAINT}"'
            f' stroke-width="0.6"/><text x="{_LEFT - 8}" y="{down(y) + 4:.1f}"'
            f' text-anchor="end" font-size="10">{number_text(y)}</text>'
        )
    yield (
        f'<path d="M{_LEFT} {top}v{_PANEL}H{_WIDTH - _RIGHT}" fill="none" stroke="{_INK}"'
        f' stroke-width="0.8"/>'
    )


def _ticks(low: float, high: float, most: int) -> list[float]:
    """Round numbers (1, 2 or 5 times a power of ten apart) within [low, high]."""
    rough = (high - low) / most
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(step for scale in (1, 2, 5, 10) if (step := scale * power) >= rough)
    first = math.ceil(low / step)
    return [round(k * step, 12) for k in range(first, math.floor(high / step) + 1)]


def _padded(low: float, high: float, share: float = 0.08) -> tuple[float, float]:
    if high - low < 1e-12 * max(1.0, abs(low)):
        return low - 1.0, high + 1.0
    return low - share * (high - low), high + share * (high - low)


def _runs(x: FloatArray, y: FloatArray) -> Iterator[Sequence[tuple[float, float]]]:
    """The finite pieces of a curve; of long ones, the lowest and highest sample of each group."""
    finite = np.isfinite(y)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], finite, [False]]).astype(np.int8)))
    for first, last in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        group = -(-(last - first) // (_MOST_POINTS // 2))
        chosen: set[int] = {first, last - 1}
        for start in range(first, last, group):
            part = y[start : min(start + group, last)]
            chosen |= {start + int(part.argmin()), start + int(part.argmax())}
        yield [(float(x[k]), float(y[k])) for k in sorted(chosen)]


def _shortened(text: str) -> str:
    return text if len(text) <= 100 else f"{text[:97]}..."
