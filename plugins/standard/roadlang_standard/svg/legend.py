"""Below the map: what each requirement and expectation says and how it came out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, rho, text
from .violations import broken

if TYPE_CHECKING:
    from roadlang.api import Scene, Verdict

_MOST_ROWS = 14


@dataclass(frozen=True)
class Row:
    """One line of the legend."""

    mark: str
    color: str
    name: str
    formula: str
    outcome: str


def rows_of(scene: Scene) -> list[Row]:
    """Requirements, then expectations; the last row counts those left out."""
    colors = {
        verdict.name: palette.violation_color(index) for index, verdict in enumerate(broken(scene))
    }
    verdicts = (*scene.requirements, *scene.expectations)
    rows = [_row(verdict, colors.get(verdict.name)) for verdict in verdicts[:_MOST_ROWS]]
    if len(verdicts) > _MOST_ROWS:
        rest = f"and {len(verdicts) - _MOST_ROWS} more"
        rows.append(Row("none", palette.QUIET_INK, rest, "", ""))
    return rows


def _row(verdict: Verdict, color: str | None) -> Row:
    if verdict.satisfied is None:
        return Row("open", palette.UNKNOWN, verdict.name, verdict.text, "when driven")
    mark = "tick" if verdict.satisfied else "cross"
    outcome = "" if verdict.robustness is None else rho(verdict.robustness)
    return Row(mark, color or palette.SATISFIED, verdict.name, verdict.text, outcome)


def height(rows: list[Row], size: float) -> float:
    """Pixels that the rows take."""
    return len(rows) * 1.55 * size


def legend(rows: list[Row], x: float, y: float, width: float, size: float) -> str:
    """Rows from (x, y) down: a mark, the name, the formula, the robustness."""
    names = max((len(row.name) for row in rows), default=0)
    column = x + 1.9 * size
    formula = column + min(names, 22) * 0.62 * size + 1.0 * size
    drawn: list[str] = []
    for index, row in enumerate(rows):
        base = y + (index + 0.8) * 1.55 * size
        drawn += _cells(row, x, base, column, formula, x + width, size)
    return group(drawn, class_="legend", font_size=size, fill=palette.INK)


def _cells(
    row: Row, x: float, base: float, column: float, formula: float, right: float, size: float
) -> Iterator[str]:
    yield _mark(row, x + 0.6 * size, base - 0.34 * size, size)
    yield text(_short(row.name, 22), column, base, font_weight="600")
    room = right - formula - 7.5 * size
    yield text(
        _short(row.formula, int(room / (0.53 * size))), formula, base, fill=palette.QUIET_INK
    )
    yield text(row.outcome, right, base, text_anchor="end", fill=row.color, font_weight="600")


def _mark(row: Row, x: float, y: float, size: float) -> str:
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


def _short(content: str, most: int) -> str:
    return content if len(content) <= most else content[: max(most - 1, 1)].rstrip() + "…"
