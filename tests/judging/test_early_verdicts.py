"""Requirements that bounds decide before any geometry: for a candidate, or for the whole scene."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import (
    DiagnosticError,
    Distribution,
    Length,
    Like,
    Number,
    Perturber,
    RoadName,
    RoadNumber,
    Signal,
    option,
)
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
SWAYING = (
    STRAIGHT + "road bent from main { perturb with sine { amplitude: HOW, wavelength: 90m } }\n"
)


def swaying(amplitude: str, *lines: str) -> str:
    return "\n".join([SWAYING.replace("HOW", amplitude), *lines, ""])


def computed(result: SamplingResult, name: str) -> int:
    """How many candidates a requirement was tried on that bounds alone had not accepted."""
    (row,) = [row for row in result.table if row.name == name]
    return row.tried - row.settled


@dataclass(frozen=True)
class Tilt(Signal):
    """A stranger's signal: never more than `steep` for each meter of displacement."""

    name: ClassVar[str] = "tilt"
    computed: ClassVar[list[int]] = []
    road: RoadName
    steep: Number = option(1.0)

    @classmethod
    def range(cls, options: Any) -> Any:
        bound = options["steep"] * options["road"].displacement
        return -bound, bound

    def values(self) -> Any:
        self.computed.append(1)
        return self.steep * self.road.displacement


@pytest.mark.parametrize("steep", ["2", "1..2"])
def test_the_range_of_a_signal_settles_a_requirement(sample: Sample, steep: str) -> None:
    """Every candidate is accepted without one value of the signal; a scene then has them."""
    Tilt.computed.clear()
    text = swaying("0m..4m", f"require flat: always (acme.tilt(bent, {steep}) < 8.1)")
    result = sample(text, 3, kinds=(Tilt,))
    assert computed(result, "flat") == 0
    assert len(result.scenes) == 3
    assert all(scene.requirements[0].satisfied for scene in result.scenes)


def test_the_range_of_a_signal_shows_what_is_impossible(sample: Sample) -> None:
    text = swaying("0m..4m", "require steep: eventually (acme.tilt(bent, 1..2) > 8.1)")
    assert sample(text, kinds=(Tilt,)).impossible == ("`eventually (acme.tilt(bent, 1..2) > 8.1)`",)


@pytest.mark.parametrize(
    ("limit", "settled"),
    [
        ("> -8.1", True), ("< 8", False), ("<= 8", False), ("< 7", False),
        ("< 8.000000005", False), ("< 8.00000001", True),
        ("> -8.000000005", False), ("> -8.00000001", True),
    ],
)  # fmt: skip
def test_a_bound_that_touches_the_limit_is_left_to_the_values(
    sample: Sample, limit: str, settled: bool
) -> None:
    requirement = f"require r: always (acme.tilt(bent, 2) {limit})"
    once = "sample with random { attempts: 1 }"
    result = sample(swaying("4m..4m", requirement, once), kinds=(Tilt,))
    assert (computed(result, "r") == 0) is settled


def test_the_displacement_bound_decides_at_its_ends(sample: Sample) -> None:
    """Up to 8 m are drawn: more than 9 m are impossible, more than 7.9 m are not."""
    assert sample(
        swaying("0m..8m", "require r: eventually (deviation(bent, main) > 9m)")
    ).impossible
    far = swaying("0m..8m", "require r: eventually (deviation(bent, main) > 7.9m)")
    result = sample(far, 1)
    assert result.impossible == ()
    assert len(result.scenes) == 1


@pytest.mark.parametrize(
    ("limit", "holds"),
    [("<= 0m", True), ("< 0m", False), (">= 0m", True), ("> 0m", False)],
)
def test_a_requirement_at_robustness_zero(sample: Sample, limit: str, holds: bool) -> None:
    """Two roads that are the same are 0 m apart: `<=` holds there, `<` does not."""
    text = STRAIGHT + "road same from main { width: 6m }\n"
    text += f"require r: always (deviation(same, main) {limit})\n"
    result = sample(text)
    assert bool(result.scenes) is holds
    if holds:
        assert result.scenes[0].requirements[0].robustness == 0
        assert result.scenes[0].requirements[0].satisfied


def test_the_bounds_of_a_draw_hold_for_all_draws_of_its_options(sample: Sample) -> None:
    """`uniform(0m..1m, 5m..6m)` is between 0 m and 6 m."""
    size = "param size = uniform(0m..1m, 5m..6m)"
    assert sample(swaying("1m", size, "require r: size > 6.01m")).impossible
    for limit in ("> 5.5m", "< 0.5m"):
        result = sample(swaying("1m", size, f"require r: size {limit}"))
        assert result.impossible == ()
        assert len(result.scenes) == 1


def test_roads_that_share_a_pass_differ_by_the_others_alone(sample: Sample) -> None:
    """Both are up to 8 m from `main`, and up to 1 m from each other."""
    text = swaying(
        "0m..8m",
        "road left from bent { perturb with sine { amplitude: 0m..0.5m, wavelength: 90m } }",
        "road right from bent { perturb with sine { amplitude: 0m..0.5m, wavelength: 90m } }",
        "require near: always (deviation(left, right) < 1.01m)",
    )
    assert computed(sample(text, 3), "near") == 0


def test_a_pass_that_draws_by_itself_is_not_decided_by_one_candidate(sample: Sample) -> None:
    """No option of `harmonics` is drawn here, and yet each candidate has a road of its own."""
    text = STRAIGHT + "road bent from main { perturb with harmonics { amplitude: 6m } }\n"
    result = sample(text + "require far: eventually (deviation(bent, main) > 4m)\n")
    assert result.candidates > 1
    assert len(result.scenes) == 1


def test_a_number_of_a_road_states_a_range(sample: Sample) -> None:
    text = swaying("0m..4m", "require far: sup_distance(bent, main) > 4.1m")
    assert sample(text).impossible == ("`sup_distance(bent, main) > 4.1m`",)


def test_an_option_that_geometry_decides_leaves_a_signal_without_range(sample: Sample) -> None:
    """Also where the option has more in it than a number of a road."""
    text = swaying("0m..4m", "require flat: always (acme.tilt(bent, 1 + length(bent) / 1km) < 30)")
    assert computed(sample(text, 3, kinds=(Tilt,)), "flat") == 3


def test_a_group_without_copies_satisfies_what_bounds_refute(sample: Sample) -> None:
    text = STRAIGHT + "object tree is tree on main at 10m { count: 0 }\n"
    result = sample(text + "require r: 3m < 2m and tree.start > 5m\n")
    assert result.impossible == ()


# --- what kinds state is checked, and the plugin named that is wrong ----------------------


def refused(sample: Sample, text: str, *kinds: type) -> str:
    with pytest.raises(DiagnosticError) as caught:
        sample(text, 2, kinds=kinds)
    (found,) = caught.value.diagnostics
    assert found.code == "RL474"
    return found.message


@dataclass(frozen=True)
class Boasting(Tilt):
    """States less than it gives."""

    name: ClassVar[str] = "boasting"

    @classmethod
    def range(cls, options: Any) -> Any:
        return -0.1, 0.1


@pytest.mark.parametrize("formula", ["always (S < 0.5)", "eventually (S > 0.5)"])
def test_a_signal_beyond_its_range(sample: Sample, formula: str) -> None:
    text = swaying("3m..4m", "require r: " + formula.replace("S", "acme.boasting(bent)"))
    message = refused(sample, text, Boasting)
    assert "signal acme.boasting" in message
    assert "beyond its range, -0.1 to 0.1" in message


@pytest.mark.parametrize("stated", [(1.0, 0.0), (float("nan"), 1.0), ([1.0] * 7, 2.0)])
def test_a_range_that_is_none(sample: Sample, stated: Any) -> None:
    class Odd(Tilt):
        """States nonsense."""

        name: ClassVar[str] = "odd"

        @classmethod
        def range(cls, options: Any) -> Any:
            return stated

    odd = dataclass(frozen=True)(Odd)
    message = refused(sample, swaying("1m..2m", "require r: always (acme.odd(bent) < 1)"), odd)
    assert "signal acme.odd" in message
    assert "gave the range" in message


@dataclass(frozen=True)
class Leap(Perturber):
    """Moves the road by twice what it states."""

    name: ClassVar[str] = "leap"
    height: Length

    def displacements(self, roads: Any, random: Any) -> Any:
        return np.atleast_2d(2 * self.height * np.ones_like(roads.stations))

    def displacement_bound(self) -> Any:
        return self.height


def test_a_displacement_beyond_its_bound(sample: Sample) -> None:
    text = STRAIGHT + "road bent from main { perturb with leap { height: 1m..2m } }\n"
    message = refused(sample, text, Leap)
    assert "perturb acme.leap" in message
    assert "beyond its bound of" in message


@dataclass(frozen=True)
class Nudge(Perturber):
    """Written for one variant: its options are plain numbers, also where it states its bound."""

    name: ClassVar[str] = "nudge"
    left: Length
    right: Length

    def displacement(self, road: Any, random: Any) -> Any:
        return np.linspace(self.left, -self.right, len(road.stations))

    def displacement_bound(self) -> float:
        return max(abs(self.left), abs(self.right))


def test_a_bound_of_a_kind_written_for_one_variant(sample: Sample) -> None:
    text = STRAIGHT + "road bent from main { perturb with nudge { left: 1m..3m, right: 0.5m } }\n"
    text += "require near: always (deviation(bent, main) < 2m)\n"
    result = sample(text, 6, kinds=(Nudge,))
    assert computed(result, "near") == result.candidates - 6  # those that are rejected


@dataclass(frozen=True)
class Wide(Distribution):
    """Gives ten times what it states."""

    name: ClassVar[str] = "wide"
    low: Like
    high: Like

    def quantile(self, uniform: Any) -> Any:
        return 10 * (self.low + (self.high - self.low) * uniform)

    def support(self) -> Any:
        return self.low, self.high


@pytest.mark.parametrize("draw", ["wide(1m, 2m)", "wide(1m, 2m..3m)"])
@pytest.mark.parametrize("limit", ["< 100m", "> 100m"])
def test_a_value_beyond_the_support(sample: Sample, draw: str, limit: str) -> None:
    """Also where the support settles the requirement, or refutes it."""
    message = refused(
        sample, swaying("1m", f"param size = {draw}", f"require r: size {limit}"), Wide
    )
    assert "distribution acme.wide" in message
    assert "beyond its support, 1 to " in message


def test_a_value_beyond_the_support_by_rounding_is_put_to_its_end(sample: Sample) -> None:
    @dataclass(frozen=True)
    class Rounded(Wide):
        """Gives 0.1 + 0.2 where it states 0.3."""

        name: ClassVar[str] = "rounded"

        def quantile(self, uniform: Any) -> Any:
            return 0.1 + 0.2 + 0.0 * uniform

    text = swaying("1m", "param size = rounded(0m, 0.3m)", "require r: size <= 0.3m")
    (scene,) = sample(text, kinds=(Rounded,)).scenes
    assert scene.values["size"] == 0.3 < 0.1 + 0.2


@pytest.mark.parametrize("support", [(2.0, 1.0), None, (1.0, 2.0)])
def test_a_support_of_constants_may_be_missing(sample: Sample, support: Any) -> None:
    @dataclass(frozen=True)
    class Some(Wide):
        """Values from 1 to 2."""

        name: ClassVar[str] = "some"

        def quantile(self, uniform: Any) -> Any:
            return 1.0 + uniform

        def support(self) -> Any:
            return support

    text = swaying("1m", "param size = some(1m, 2m)", "require r: size > 0m")
    if support == (2.0, 1.0):
        with pytest.raises(DiagnosticError, match="RL207"):
            sample(text, kinds=(Some,))
    else:
        assert sample(text, kinds=(Some,)).scenes


@dataclass(frozen=True)
class DoubleLength(RoadNumber):
    """Twice the length of a road; states that it is at most 10 m."""

    name: ClassVar[str] = "double"
    unit: ClassVar[str] = "m"
    road: RoadName

    @classmethod
    def range(cls, options: Any) -> Any:
        return 0.0, 10.0

    def values(self) -> Any:
        return 2 * self.road.length


def test_a_number_beyond_its_range(sample: Sample) -> None:
    message = refused(sample, STRAIGHT + "require r: acme.double(main) > 20m\n", DoubleLength)
    assert "number acme.double" in message


@pytest.mark.parametrize(("first", "second"), [("0m..4m", "0m..1m"), ("0m..1m", "0m..4m")])
def test_two_draws_of_one_distribution_have_bounds_of_their_own(
    sample: Sample, first: str, second: str
) -> None:
    """Together up to 5 m: more than that is impossible, and a little less is not."""
    text = swaying(
        first,
        f"road late from bent {{ perturb with sine {{ amplitude: {second}, wavelength: 90m }} }}",
        "require far: eventually (deviation(late, main) > LIMIT)",
    )
    assert sample(text.replace("LIMIT", "5.1m")).impossible
    assert not sample(text.replace("LIMIT", "4.9m")).impossible


@pytest.mark.parametrize("least", [0.04, 0.06, 0.2])
def test_a_road_that_no_draw_moves_so_far_needs_no_geometry(sample: Sample, least: float) -> None:
    text = swaying("1cm..5cm", f"require near: always (abs(deviation(bent, main)) < {least}m)")
    assert (computed(sample(text, 8), "near") == 0) == (least > 0.05)
