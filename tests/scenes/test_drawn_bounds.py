"""Numbers that nothing bounds before they are drawn keep the bounds of their options, whatever they
are options of; constants and computed numbers may be off by rounding."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Anything, Controller, ListOf, option
from roadlang.diagnostics import DiagnosticError
from roadlang.evaluate.option_bounds import check_number
from roadlang.plugins.options import schema_of
from roadlang.session.scene_set import SceneSet

TEXT = """
param base = 1.1
param more = choice(2.2, 2.2)
road main {{ draw with segments {{ pieces: [straight(200m)] }} {road} }}
world {{ {world} }}
agent ego is car on main at 60m {{
  {agent} {sense}
  drive with lane_follow {{ {drive} }}
}}
object tree is tree on main at 100m {{ side: right {object} }}
simulate with builtin {{ duration: {duration} }}
"""
WRONG = [
    ("agent", "start_speed: normal(-5m/s, 0.1m/s),", "start_speed", "ego"),
    ("agent", "offset: normal(3000m, 1m),", "offset", "ego"),
    ("agent", "apart: normal(-5m, 0.1m),", "apart", "ego"),
    ("agent", "count: 2, spacing: normal(30km, 1m),", "spacing", "ego"),
    ("object", ", offset: normal(3000m, 1m)", "offset", "tree"),
    ("sense", "sense with gps { dropout: normal(3, 0.1) }", "dropout", "gps"),
    ("sense", "sense with gps { delay: normal(-3s, 0.1s) }", "delay", "gps"),
    ("drive", "speed: normal(-5m/s, 0.1m/s)", "speed", "lane_follow"),
    ("drive", "speed: 5m/s * normal(-1, 0.01)", "speed", "lane_follow"),
    ("world", "friction: normal(5, 0.1)", "friction", "world"),
    ("world", "visibility: normal(-5m, 0.1m)", "visibility", "world"),
    ("world", "friction: normal(5, 0.1) + 0.1", "friction", "world"),
    ("world", "sun: { azimuth: normal(20rad, 0.1rad) }", "azimuth", "sun"),
    ("world", "sun: { azimuth: 1rad, elevation: 9rad * normal(1, 0.1) }", "elevation", "sun"),
    ("road", ", speed_limit: normal(-5m/s, 0.1m/s)", "speed_limit", "main"),
]


def sampled(place: str, written: str) -> SceneSet:
    empty = dict.fromkeys(("road", "world", "agent", "sense", "drive", "object"), "")
    return testing.sample(TEXT.format(**{**empty, "duration": "5s", place: written}), 3)


@pytest.mark.parametrize(("place", "written", "option", "owner"), WRONG)
def test_what_is_drawn_beyond_a_bound_is_told(
    place: str, written: str, option: str, owner: str
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sampled(place, written)
    assert "RL473" in str(caught.value)
    assert f"`{option}` of `{owner}` would be" in str(caught.value)
    (found,) = caught.value.diagnostics
    assert found.span is not None


@pytest.mark.parametrize(
    ("place", "written"),
    [
        ("sense", "sense with gps { dropout: normal(0.5, 9, within: [0, 1]) }"),
        ("sense", "sense with gps { dropout: base + more - 2.3 }"),  # 1.0000000000000004
        ("world", "friction: max(0.1, normal(0.8, 0.1))"),
        ("world", "sun: { azimuth: normal(1rad, 0.1rad), elevation: normal(1rad, 0.01rad) }"),
        ("agent", "start_speed: max(0m/s, normal(0m/s, 9m/s)),"),
    ],
)
def test_what_is_kept_within_bounds_or_beyond_by_rounding_is_taken(
    place: str, written: str
) -> None:
    assert len(sampled(place, written)) == 3


@dataclass(frozen=True)
class Loose(Controller):
    """One with a list of anything, in which numbers have the bounds of the list."""

    name: ClassVar[str] = "loose"
    gains: ListOf[Anything] = option((), maximum=2.0, help="how much")


def test_numbers_in_a_list_of_anything_have_its_bounds() -> None:
    (schema,) = schema_of(Loose)
    for fits in ((1.0, 2.0), ("much",), (1.0, "much")):
        check_number(schema, fits, "loose", None)
    for beyond in ((1.0, 2.5), ("much", 2.5), (np.array([[1.0], [2.5]]),)):
        with pytest.raises(DiagnosticError, match="RL473"):
            check_number(schema, beyond, "loose", None)
