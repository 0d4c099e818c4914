"""The key at the foot of a figure of a drive."""

from __future__ import annotations

import itertools
from xml.etree import ElementTree

import pytest

from roadlang.drive.figure_key import Shown, figure_key
from roadlang.drive.robustness_colors import OTHER


def key(shown: Shown, scale: float = 10.0) -> ElementTree.Element:
    return ElementTree.fromstring(figure_key(shown, scale, (24.0, 876.0), 100.0))


def words(root: ElementTree.Element) -> list[str | None]:
    return [text.text for text in root.iter("text")]


def test_the_key_names_what_the_figure_shows() -> None:
    everything = key(Shown("a<b", has_others=True, has_ring=True))
    assert words(everything) == [
        "a<b: violated", "satisfied", "other agents", "deciding moment", "10 m"
    ]  # fmt: skip
    colors = [line.get("stroke") for line in everything.iter("line")]
    shades = ["#c92a2a", "#f59f00", "#af9f18", "#699e30", "#2f9e44"]
    assert colors == [*shades, OTHER, "#23272b"]
    assert len(everything.findall("circle")) == 1
    assert words(key(Shown("", has_others=True, has_ring=False))) == ["agents", "10 m"]
    assert words(key(Shown("ego", has_others=False, has_ring=False))) == [
        "ego: violated", "satisfied", "10 m"
    ]  # fmt: skip


def test_the_parts_of_a_key_do_not_overlap() -> None:
    starts = [
        float(text.get("x") or 0)
        for text in key(Shown("ego", has_others=True, has_ring=True)).iter("text")
    ]
    assert starts == sorted(starts)
    assert min(b - a for a, b in itertools.pairwise(starts)) > 60


@pytest.mark.parametrize(
    ("scale", "label", "long"), [(10.0, "10 m", 100), (0.05, "2 km", 100), (100.0, "1 m", 100)]
)
def test_the_scale_bar_is_a_round_length(scale: float, label: str, long: float) -> None:
    """At most 14 % of 852 px, up to the right side."""
    root = key(Shown("", has_others=False, has_ring=False), scale)
    (bar,) = root.findall("line")
    assert words(root) == [label]
    assert float(bar.get("x2") or 0) == 876
    assert float(bar.get("x1") or 0) == pytest.approx(876 - long)
