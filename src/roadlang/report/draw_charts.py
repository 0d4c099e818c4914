"""The random values that set failing drives apart from the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..falsification.statistics import measure_coverage
from ..geometry.arrays import Booleans
from ..ir.result_columns import named_in
from .charts import coverage_chart
from .elements import element, text
from .numbers import percent, shown_unit
from .results import ResultRow

MOST = 6
_LEAST = 0.1
"""Separation below which a value is not shown: chance does as much."""


def draw_charts(rows: Sequence[ResultRow], units: Mapping[str, str]) -> str:
    """Histograms of the draws that differ most between failing drives and others; nothing where
    all fail, or none."""
    failed = np.array([row.has_failed for row in rows], dtype=bool)
    if failed.all() or not failed.any():
        return ""
    names = dict.fromkeys(name for row in rows for name in row.draws)
    found = {name: separation([row.values.get(name) for row in rows], failed) for name in names}
    ranked = sorted(found, key=lambda name: -abs(found[name]))
    charts = [
        _chart(name, rows, units.get(named_in(name), ""), found[name])
        for name in ranked[:MOST]
        if abs(found[name]) >= _LEAST
    ]
    return element("div", *charts, class_="charts")


def separation(values: Sequence[object], failed: Booleans) -> float:
    """How far failing drives have larger values: the chance that one of them has a larger value
    than another drive, less the chance of a smaller (Cliff 1993, delta); from -1 to 1.

    0 for what is not a number in every drive.
    """
    if not all(isinstance(v, int | float) and not isinstance(v, bool) for v in values):
        return 0.0
    numbers = np.array(values, dtype=float)
    others = np.sort(numbers[~failed])
    below = np.searchsorted(others, numbers[failed], "left")
    above = len(others) - np.searchsorted(others, numbers[failed], "right")
    return float((below - above).mean() / len(others))


def _chart(name: str, rows: Sequence[ResultRow], unit: str, delta: float) -> str:
    factor, shown = shown_unit(unit)
    drives = [({name: _number(row.values[name]) * factor}, row.has_failed) for row in rows]
    chart = coverage_chart(name, measure_coverage(drives)[name], shown)
    direction = "larger" if delta > 0 else "smaller"
    note = f" {direction} where it fails: {percent((1.0 + abs(delta)) / 2.0)} of pairs"
    caption = element("figcaption", element("strong", text(name)), text(note))
    return element("figure", caption, chart)


def _number(value: object) -> float:
    assert isinstance(value, int | float)
    return float(value)
