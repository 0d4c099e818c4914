"""Below the map: what each requirement and expectation says and how it came out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, rho, text
from .violations import broken
from .wrapping import BOLD_LETTER, letters, wrapped

if TYPE_CHECKING:
    from roadlang.api import Scene, Verdict

_MOST_ROWS = 14
_LINE = 1.25
_ROW_GAP = 0.3
_LONGEST_NAME = 22
_OUTCOME = 7.5


@dataclass(frozen=True)
class LegendRow:
    """One requirement or expectation of the legend."""

    mark: str
    color: str
    name: str
    formula: str
    outcome: str


@dataclass(frozen=True)
class Legend:
    """Rows laid out `width` pixels wide at a font size; long formulas take several lines."""

    rows: tuple[LegendRow, ...]
    width: float
    size: float

    @property
    def _formula(self) -> float:
        """Pixels from the left at which formulas begin."""
        longest = max((len(row.name) for row in self.rows), default=0)
        return (2.9 + BOLD_LETTER * min(longest, _LONGEST_NAME)) * self.size

    def _lines(self, row: LegendRow) -> list[str]:
        room = self.width - self._formula - _OUTCOME * self.size
        return wrapped(row.formula, letters(room, self.size))

    def _height(self, row: LegendRow) -> float:
        return (_LINE * len(self._lines(row)) + _ROW_GAP) * self.size

    @property
    def height(self) -> float:
        """Pixels that all rows take."""
        return sum(map(self._height, self.rows))

    def drawn(self, x: float, y: float) -> str:
        """From (x, y) down: a mark, the name, the formula, the robustness."""
        cells: list[str] = []
        for row in self.rows:
            cells += self._cells(row, x, y + self.size)
            y += self._height(row)
        return group(cells, class_="legend", font_size=self.size, fill=palette.INK)

    def _cells(self, row: LegendRow, x: float, base: float) -> Iterator[str]:
        size = self.size
        yield _mark(row, x + 0.6 * size, base - 0.34 * size, size)
        yield text(_short(row.name), x + 1.9 * size, base, font_weight="600")
        for number, line in enumerate(self._lines(row)):
            if line:
                below = base + number * _LINE * size
                yield text(line, x + self._formula, below, fill=palette.MUTED_INK)
        yield text(row.outcome, x + self.width, base, text_anchor="end", fill=row.color,
                   font_weight="600")  # fmt: skip


def legend_of(scene: Scene, width: float, size: float) -> Legend:
    """Requirements, then expectations; the last row counts those left out."""
    colors = {
        verdict.name: palette.violation_color(index) for index, verdict in enumerate(broken(scene))
    }
    verdicts = (*scene.requirements, *scene.expectations)
    rows = [_row(verdict, colors.get(verdict.name)) for verdict in verdicts[:_MOST_ROWS]]
    if len(verdicts) > _MOST_ROWS:
        rest = f"and {len(verdicts) - _MOST_ROWS} more"
        rows.append(LegendRow("none", palette.MUTED_INK, rest, "", ""))
    return Legend(tuple(rows), width, size)


def _row(verdict: Verdict, color: str | None) -> LegendRow:
    if verdict.satisfied is None:
        return LegendRow("open", palette.UNKNOWN, verdict.name, verdict.text, "when driven")
    mark = "tick" if verdict.satisfied else "cross"
    outcome = "" if verdict.robustness is None else rho(verdict.robustness)
    return LegendRow(mark, color or palette.SATISFIED, verdict.name, verdict.text, outcome)


def _mark(row: LegendRow, x: float, y: float, size: float) -> str:
    line = {"fill": "none", "stroke": row.color, "stroke_width": 0.17 * size,
            "stroke_linecap": "round", "stroke_linejoin": "round"}  # fmt: skip
    r = 0.36 * size
    strokes = {
        "tick": [(-r, 0.0), (-0.25 * r, 0.75 * r), (r, -0.8 * r)],
        "cross": [(-r, -r), (r, r), (0.0, 0.0), (-r, r), (r, -r)],
    }
    if row.mark in strokes:
        points = " ".join(f"{x + dx:.2f},{y + dy:.2f}" for dx, dy in strokes[row.mark])
        return element("polyline", points=points, **line)
    if row.mark == "open":
        return element("circle", cx=x, cy=y, r=0.75 * r, **line)
    return ""


def _short(name: str) -> str:
    return name if len(name) <= _LONGEST_NAME else name[: _LONGEST_NAME - 1].rstrip() + "…"
