"""Kinds that do not say how short their waves are: a remark tells what the stations hide."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import Length, Perturber, option
from roadlang.testing import sample
from tests.straight_road import STRAIGHT


@dataclass(frozen=True)
class Ripple(Perturber):
    """A wave."""

    name: ClassVar[str] = "ripple"
    is_random: ClassVar[bool] = False
    wavelength: Length = option(above=0, help="one period")

    def displacements(self, roads: Any, random: Any) -> Any:
        return np.atleast_2d(0.01 * np.sin(2 * np.pi / self.wavelength * roads.stations))


@dataclass(frozen=True)
class Potholes(Perturber):
    """Something else at each station."""

    name: ClassVar[str] = "potholes"

    def displacements(self, roads: Any, random: Any) -> Any:
        return 0.01 * random.uniform(len(roads.stations))


@dataclass(frozen=True)
class Shift(Perturber):
    """A displacement in the plane, the same everywhere."""

    name: ClassVar[str] = "drift"
    is_random: ClassVar[bool] = False

    def displacement(self, road: Any, random: Any) -> Any:
        return np.full((len(road.stations), 2), (3.0, -4.0))


@dataclass(frozen=True)
class OnlyMeters(Perturber):
    """Fails with other stations than those of the road."""

    name: ClassVar[str] = "only_meters"

    def displacements(self, roads: Any, random: Any) -> Any:
        assert len(roads.stations) == 201
        return np.zeros((1, 201))


KINDS = (Ripple, Potholes, Shift, OnlyMeters)


def remarks(perturbation: str, road: str = STRAIGHT) -> tuple[str, ...]:
    text = road + "road bent from main { perturb with " + perturbation + " }\n"
    return sample(text, 3, kinds=KINDS).remarks


@pytest.mark.parametrize("wavelength", ["50cm", "1m", "2m", "4m", "5m"])
def test_waves_that_the_stations_hide_are_remarked_on(wavelength: str) -> None:
    """At stations a meter apart a wave of a meter, or of two, is zero at each of them."""
    (remark,) = remarks(f"ripple {{ wavelength: {wavelength} }}")
    assert "perturb with tested.ripple" in remark
    assert "`bent`" in remark
    assert "set `station_spacing`" in remark


def test_waves_that_they_show_are_not() -> None:
    assert remarks("ripple { wavelength: 8m }") == ()
    assert remarks("ripple { wavelength: 8m..200m }") == ()
    fine = STRAIGHT.replace("width: 8m", "width: 8m, station_spacing: 0.2m")
    assert remarks("ripple { wavelength: 2m }", fine) == ()
    assert remarks("sine { amplitude: 1cm, wavelength: 2m }") == ()


def test_closed_roads_are_looked_at_round_their_seam() -> None:
    ring = (
        "road main { draw with waypoints { points:"
        " [(30m, 0m), (0m, 30m), (-30m, 0m), (0m, -30m)] }, closed: true }\n"
    )
    assert remarks("drift", ring) == ()
    # 188 m are no whole number of such waves: it jumps at the seam.
    assert len(remarks("ripple { wavelength: 40m }", ring)) == 1
    assert len(remarks("ripple { wavelength: 2m }", ring)) == 1


def test_what_changes_with_the_number_of_stations_is_remarked_on() -> None:
    (remark,) = remarks("potholes")
    assert "not a function of arc length" in remark


def test_displacements_in_the_plane_are_compared_too() -> None:
    text = STRAIGHT + "road bent from main { perturb with drift }\n"
    made = sample(text, kinds=KINDS)
    assert made.remarks == ()
    road = made[0].roads["bent"]
    assert (road.x[0], road.y[0]) == pytest.approx((3.0, -4.0))
    assert road.length == pytest.approx(200.0)


def test_a_kind_that_fails_with_more_stations_has_done_its_work() -> None:
    assert remarks("only_meters") == ()


def test_on_an_interval_a_displacement_in_the_plane_keeps_its_part_along_the_normal() -> None:
    text = (
        STRAIGHT + "road bent from main { perturb with drift { over: [50m, 150m], taper: 20m } }\n"
    )
    road = sample(text, kinds=KINDS)[0].roads["bent"]
    assert road.y.min() == pytest.approx(-4.0)
    np.testing.assert_allclose(road.x, np.linspace(0.0, 200.0, 201), atol=1e-9)
