"""A plot of a verdict, by hand: 762 pixels for 4 s, panels of 130 pixels below each other."""

from __future__ import annotations

import re
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang import stl
from roadlang.stl.explain.plot import plot_svg

TIME = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
LEFT, RIGHT = 74.0, 836.0
FIRST, SECOND = 76.0, 250.0
"""Upper edges of the first two panels."""


def plot(text: str, **signals: Any) -> ElementTree.Element:
    drawn = plot_svg(stl.parse(text), TIME, {k: np.array(v, float) for k, v in signals.items()},
                     axis="time (s)")  # fmt: skip
    return ElementTree.fromstring(drawn.replace(' xmlns="http://www.w3.org/2000/svg"', ""))


def curve(root: ElementTree.Element, number: int) -> list[tuple[float, float]]:
    line = root.findall("polyline")[number].get("points") or ""
    return [(float(x), float(y)) for x, y in (pair.split(",") for pair in line.split())]


def levels(root: ElementTree.Element) -> list[float]:
    """Heights of the dashed lines."""
    paths = [path.get("d") or "" for path in root.findall("path") if path.get("stroke-dasharray")]
    return [float(path.split()[1].split("H")[0]) for path in paths]


def texts(root: ElementTree.Element) -> list[str]:
    return [text.text or "" for text in root.findall("text")]


def height(value: float, low: float, high: float, top: float) -> float:
    """Of a value in a panel from `low` to `high` with 8 % on both sides."""
    pad = 0.08 * (high - low)
    return top + 130 - (value - low + pad) / (high - low + 2 * pad) * 130


def test_the_robustness_and_each_signal_have_a_panel() -> None:
    """Of `always p` the robustness of p is drawn: 6 - e, from 5 down to -1; e from 1 to 7."""
    root = plot("always (e < 6)", e=[1, 3, 5, 7, 5])
    assert [x for x, _ in curve(root, 0)] == [LEFT, 264.5, 455, 645.5, RIGHT]
    for line, values, low, high, top in ((0, [5, 3, 1, -1, 1], -1, 5, FIRST),
                                         (1, [1, 3, 5, 7, 5], 1, 7, SECOND)):  # fmt: skip
        expected = [height(value, low, high, top) for value in values]
        assert [y for _, y in curve(root, line)] == pytest.approx(expected, abs=0.06)
    assert {"robustness of e < 6", "e", "time (s)", "always (e < 6)"} <= set(texts(root))
    assert (root.get("width"), root.get("height")) == ("860", str(76 + 2 * 174 + 22))


def test_a_trace_that_begins_later_has_the_same_curves() -> None:
    formula, e = stl.parse("always (e < 6)"), {"e": np.array([1.0, 3.0, 5.0, 7.0, 5.0])}
    plots = [plot_svg(formula, TIME + shift, e, axis="time (s)") for shift in (0.0, 7.0)]
    drawn = [re.findall(r'(?:points|<rect class="violated" x)="[^"]*"', plot) for plot in plots]
    assert len(drawn[0]) > 2
    assert drawn[0] == drawn[1]


def test_thresholds_are_dashed_lines_with_their_comparison() -> None:
    """Zero of the robustness; 6 of e."""
    root = plot("always (e < 6)", e=[1, 3, 5, 7, 5])
    assert levels(root) == pytest.approx(
        [height(0, -1, 5, FIRST), height(6, 1, 7, SECOND)], abs=0.06
    )
    assert "e < 6" in texts(root)


@pytest.mark.parametrize(
    ("text", "bounds"),
    [("always (e < 6)", [6]), ("always (6 > e)", [6]), ("always (abs(e) < 6)", [-6, 6]),
     ("always (e + 1 < 6)", []), ("always (min(e, 1) < 6)", []),
     ("always (e < 6 and e > 2)", [2, 6]),
     ("always (e < f)", [])],
)  # fmt: skip
def test_thresholds_are_constants_that_a_signal_or_its_size_is_compared_with(
    text: str, bounds: list[float]
) -> None:
    root = plot(text, e=[1, 3, 5, 7, 5], f=[9, 9, 9, 9, 9])
    below = [y for y in levels(root) if y > SECOND - 1 and y < SECOND + 131]
    low, high = min(1, *bounds, 1), max(7, *bounds, 7)
    expected = sorted(height(bound, low, high, SECOND) for bound in bounds)
    assert sorted(below) == pytest.approx(expected, abs=0.06)


def test_what_is_violated_is_shaded_and_what_decides_has_a_dot() -> None:
    """The one sample at 3 s: 2 px wide at 645.5, in the panels of the robustness and of e."""
    root = plot("always (e < 6)", e=[1, 3, 5, 7, 5])
    shaded = [(float(box.get("x") or 0), float(box.get("y") or 0), float(box.get("width") or 0))
              for box in root.findall("rect") if box.get("class") == "violated"]  # fmt: skip
    assert [y for _, y, _ in shaded] == [FIRST, SECOND]
    assert all(x <= 645.5 <= x + width + 0.1 for x, _, width in shaded)
    (dot,) = root.findall("circle")
    assert (float(dot.get("cx") or 0), float(dot.get("cy") or 0)) == pytest.approx(
        (645.5, height(7, 1, 7, SECOND)), abs=0.06
    )
    assert not [box for box in plot("always (e < 9)", e=[1, 3, 5, 7, 5]).findall("rect")
                if box.get("class")]  # fmt: skip


def test_a_formula_that_looks_back_has_its_own_robustness_drawn() -> None:
    assert "robustness" in texts(plot("historically (e < 6)", e=[1, 3, 5, 7, 5]))
    assert "robustness of e < 6" in texts(plot("eventually (e < 6)", e=[1, 3, 5, 7, 5]))


def test_a_signal_that_does_not_change_lies_in_the_middle() -> None:
    root = plot("always (e > f)", e=[3] * 5, f=[1] * 5)
    assert {y for _, y in curve(root, 1)} == {SECOND + 65}


def test_gaps_of_a_curve_are_left_open() -> None:
    """Infinite robustness is not drawn: 1 / 0 parts the curve."""
    root = plot("1 / e < 6", e=[1, 1, 0, 1, 1])
    assert len(root.findall("polyline")) >= 2


def test_ticks_are_round_numbers() -> None:
    """From 0 s to 4 s in steps of half a second, 9 of them."""
    shown = texts(plot("always (e < 6)", e=[1, 3, 5, 7, 5]))
    assert {"0", "0.5", "1.5", "2.5", "3.5"} <= set(shown)
