"""Charts of a search: each mark is where its number belongs."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang.falsification.statistics import Coverage
from roadlang.report.charts import coverage_chart, progress_chart


def labels(chart: ElementTree.Element) -> dict[tuple[str, bool], tuple[float, float]]:
    """Places of labels by their text, and whether they are beside the chart."""
    found = {}
    for part in chart.iter():
        if part.tag.endswith("text"):
            words = str(part.text).replace("\N{NO-BREAK SPACE}", " ").replace("\N{MINUS SIGN}", "-")
            at = float(part.attrib["x"]), float(part.attrib["y"])
            found[words, at[0] < 44.0] = at
    return found


def marks(chart: ElementTree.Element, kind: str) -> list[tuple[float, float]]:
    found = [part.attrib["d"] for part in chart.iter() if part.get("class") == kind]
    return [(float(x), float(y)) for x, y in re.findall(r"M([\d.]+) ([\d.]+)", "".join(found))]


def test_drives_of_a_search_lie_on_the_scales_beside_them() -> None:
    robustness = [3.0, -2.0, 1.0, 4.0, 0.5]
    failed = [value < 0 for value in robustness]
    chart = ElementTree.fromstring(
        progress_chart(range(5), robustness, failed, [(0, 3.0), (1, -2.0)], "m")
    )
    at = labels(chart)
    zero, low, high = (at[words, True][1] - 4.0 for words in ("0", "-2 m", "4 m"))
    per_meter = (low - zero) / -2.0
    assert per_meter < 0.0
    assert zero + 3.96 * per_meter == pytest.approx(high, abs=0.2)  # the 99 % quantile
    safe, (failing,) = marks(chart, "dots safe"), marks(chart, "dots failed")
    dots = [safe[0], failing, *safe[1:]]
    across = np.diff([x for x, _ in dots])
    np.testing.assert_allclose(across, across.mean(), atol=0.2)
    assert across.mean() > 60.0
    for (_, y), value in zip(dots, robustness, strict=True):
        assert y == pytest.approx(zero + min(value, 4.04) * per_meter, abs=1.5)
    (best,) = (part.attrib["d"] for part in chart.iter() if part.get("class") == "best")
    levels = [float(y) for y in re.findall(r"(?:M[\d.]+ |V)([\d.]+)", best)]
    assert levels == pytest.approx([dots[0][1], failing[1]], abs=0.2)
    first, last, title = (at[words, False][0] for words in ("0", "4", "evaluation"))
    assert title == pytest.approx((first + last) / 2.0, abs=0.2)
    assert (first, last) == pytest.approx((dots[0][0], dots[-1][0]), abs=0.2)


def test_a_label_that_would_lie_on_another_is_left_out() -> None:
    chart = ElementTree.fromstring(progress_chart([0, 1], [0.1, 9.0], [False, False], [], "m"))
    assert [words for words, beside in labels(chart) if beside] == ["0", "8.9 m"]


def test_bars_of_coverage_are_as_tall_as_their_counts() -> None:
    scenes, failures = (4, 0, 8, 1), (1, 0, 6, 0)
    chart = ElementTree.fromstring(
        coverage_chart("gap", Coverage(2.0, 10.0, scenes, failures), "m")
    )
    rects = [part.attrib for part in chart.iter() if part.tag.endswith("rect")]
    kinds = [rect["class"] for rect in rects]
    x, y, heights = ([float(rect[name]) for rect in rects] for name in ("x", "y", "height"))
    counts = [
        (kind, round(height / max(heights) * 8))
        for kind, height in zip(kinds, heights, strict=True)
    ]
    assert counts == [
        ("bar safe", 4), ("bar failed", 1), ("bar safe", 8), ("bar failed", 6), ("bar safe", 1),
    ]  # fmt: skip
    assert len({top + height for top, height in zip(y, heights, strict=True)}) == 1
    steps = [after - before for before, after in zip(x, x[2:], strict=False)]
    assert steps == pytest.approx([2 * steps[2], 2 * steps[2], steps[2]], abs=0.2)
    found = labels(chart)
    assert set(found) == {("8", True), ("2 m", False), ("10 m", False)}
    assert found["2 m", False][0] < min(x) <= found["10 m", False][0]
