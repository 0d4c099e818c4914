"""The key at the foot of a figure of a drive: what the colors mean, and a scale bar."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from html import escape

from ..geometry.numbers.round_lengths import round_length
from ..scenes.figure_colors import FIGURE_COLORS
from .robustness_colors import OTHER, robustness_color

_FONT, _LETTER = 12.0, 6.6
"""Pixels: the size of the text, and the width of an average letter."""
_BAR = 0.14
"""The longest scale bar, as a share of the width"""
_SWATCH, _GAP = 13.0, 8.0
_SHARES = (-1.0, 0.0, 0.125, 0.5, 1.0)
"""Robustness, of the swatches, as parts of the greatest"""


@dataclass(frozen=True)
class Shown:
    """What a figure shows: the agent whose path has the colors of robustness ("" for none), paths
    of others, a ring at the moment that decides."""

    judged: str
    has_others: bool
    has_ring: bool


def figure_key(shown: Shown, scale: float, sides: tuple[float, float], y: float) -> str:
    """An SVG group between two x, with its baseline at `y`. `scale`: pixels of a meter."""
    left, right = sides
    parts = [*_colors(shown, left, y), *_scale_bar(scale, right, _BAR * (right - left), y)]
    font = f'font-size="{_FONT:.0f}" font-family="Helvetica, Arial, sans-serif"'
    return f'<g class="key" fill="{FIGURE_COLORS.ink}" {font}>{"".join(parts)}</g>'


def _colors(shown: Shown, x: float, y: float) -> Iterator[str]:
    middle = y - 4.0
    if shown.judged:
        words = f"{shown.judged}: violated"
        yield _text(words, x, y)
        x += _LETTER * len(words) + _GAP
        for share in _SHARES:
            yield _line(x, x + _SWATCH, middle, robustness_color(share), 4.0)
            x += _SWATCH
        yield _text("satisfied", x + _GAP, y)
        x += _LETTER * len("satisfied") + 3.0 * _GAP
    if shown.has_others:
        words = "other agents" if shown.judged else "agents"
        yield _line(x, x + 2.0 * _SWATCH, middle, OTHER, 1.5)
        x += 2.0 * _SWATCH + _GAP
        yield _text(words, x, y)
        x += _LETTER * len(words) + 2.0 * _GAP
    if shown.has_ring:
        ring = f'cx="{x + 6.0:.1f}" cy="{middle:.1f}" r="6" stroke-width="1.5"'
        yield f'<circle {ring} fill="none" stroke="{FIGURE_COLORS.ink}"/>'
        yield _text("deciding moment", x + 12.0 + _GAP, y)


def _scale_bar(scale: float, right: float, longest: float, y: float) -> Iterator[str]:
    meters = round_length(longest / scale)
    label = f"{meters / 1000:g} km" if meters >= 1000 else f"{meters:g} m"
    left = right - meters * scale
    yield _text(label, left - _GAP, y, 'text-anchor="end"')
    yield _line(left, right, y - 4.0, FIGURE_COLORS.ink, 4.0)


def _text(content: str, x: float, y: float, more: str = "") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" {more}>{escape(content, quote=False)}</text>'


def _line(x1: float, x2: float, y: float, color: str, width: float) -> str:
    ends = f'x1="{x1:.1f}" y1="{y:.1f}" x2="{x2:.1f}" y2="{y:.1f}"'
    return f'<line {ends} stroke="{color}" stroke-width="{width:g}"/>'
