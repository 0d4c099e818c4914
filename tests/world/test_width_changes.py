"""Stations where the lanes of maps change their width within a meter."""

from __future__ import annotations

import numpy as np
from shapely import LineString, distance, points

from roadlang.geometry import CrossSection, Lane, WidthProfile
from roadlang.geometry.arrays import Floats
from roadlang.world.networks.width_changes import with_width_changes

EVEN = np.linspace(0.0, 100.0, 101)


def section(stations: list[float], widths: list[float]) -> CrossSection:
    profile = WidthProfile(np.array(stations), np.array(widths))
    inner = Lane(-1, "drive", WidthProfile.constant(3.5), "forward")
    return CrossSection((inner, Lane(-2, "parking", profile, "none", drivable=False)))


def missed(lanes: CrossSection, stations: Floats) -> float:
    """How far the outer border is from what is straight between stations."""
    given = lanes.stations
    true = LineString(np.column_stack((given, lanes.border_offsets(given)[-1])))
    shown = LineString(np.column_stack((stations, lanes.border_offsets(stations)[-1])))
    return float(
        max(distance(points(true.coords), shown).max(), distance(points(shown.coords), true).max())
    )


def test_a_step_is_two_stations_that_are_2_cm_apart() -> None:
    for at in (40.3, 40.0, 40.995):
        lanes = section([0.0, at - 1e-6, at, 100.0], [2.0, 2.0, 0.5, 0.5])
        found = with_width_changes(EVEN, lanes)
        assert missed(lanes, EVEN) > 0.4
        assert missed(lanes, found) < 0.02
        assert 0.0199 < np.diff(found).min() < 0.0201
        assert len(found) in (102, 103)
        assert found[[0, -1]].tolist() == [0.0, 100.0]


def test_a_bend_between_stations_is_one() -> None:
    lanes = section([0.0, 30.5, 32.5, 100.0], [2.0, 2.0, 1.0, 1.0])
    found = with_width_changes(EVEN, lanes)
    assert sorted(set(found.tolist()) - set(EVEN.tolist())) == [30.5, 32.5]


def test_what_even_stations_show_adds_none() -> None:
    assert with_width_changes(EVEN, section([0.0, 20.0, 100.0], [2.0, 1.0, 3.0])) is EVEN
    assert with_width_changes(EVEN, section([0.0], [2.0])) is EVEN
    ends = section([0.0, 1e-6, 99.999999, 100.0], [1.0, 2.0, 2.0, 1.0])
    assert with_width_changes(EVEN, ends) is EVEN
