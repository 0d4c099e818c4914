"""What reaches the methods of a plugin, and what it may give back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import (
    Length,
    Perturber,
    Point,
    RoadName,
    RoadNumber,
    Signal,
    Word,
    list_of,
    map_of,
    option,
)
from roadlang.diagnostics import DiagnosticError
from roadlang.plugins.kinds import Kind
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BENT = "road bent from main { perturb with KIND }\n"


@dataclass(frozen=True)
class Steps(Perturber):
    """One variant at a time: every option is plain."""

    name: ClassVar[str] = "steps"
    side: Word = option(words=("left", "right"))
    sizes: list_of(Length) = option()  # type: ignore[valid-type]
    middle: Point = option()
    named: map_of(Length) = option()  # type: ignore[valid-type]

    def displacement(self, road: Any, random: Any) -> Any:
        assert self.side in ("left", "right")
        plain = (*self.sizes, *self.middle, *self.named.values())
        assert all(type(number) is float for number in plain)
        sign = 1.0 if self.side == "left" else -1.0
        return sign * sum(self.sizes) * np.ones(len(road.stations))


@dataclass(frozen=True)
class Swell(Perturber):
    """Uses the length of the road, which is (1, 1)."""

    name: ClassVar[str] = "swell"

    def displacement(self, road: Any, random: Any) -> Any:
        return np.sin(np.pi * road.stations / road.length)


@dataclass(frozen=True)
class Slope(Perturber):
    """A batch method that thinks of nothing but stations."""

    name: ClassVar[str] = "slope"
    rise: Length = option()

    def displacements(self, roads: Any, random: Any) -> Any:
        return self.rise * roads.stations / 200.0


@dataclass(frozen=True)
class Milestone(Signal):
    """Arc length itself, alike in all variants."""

    name: ClassVar[str] = "milestone"
    unit: ClassVar[str] = "m"
    road: RoadName = option()

    def values(self) -> Any:
        return self.road.stations


@dataclass(frozen=True)
class Clipped(Signal):
    """Forgets the last station."""

    name: ClassVar[str] = "clipped"
    road: RoadName = option()

    def values(self) -> Any:
        return self.road.curvature[:, :-1]


@dataclass(frozen=True)
class Doubtful(RoadNumber):
    """A number that is none."""

    name: ClassVar[str] = "doubtful"
    road: RoadName = option()

    def values(self) -> Any:
        return np.array([[np.nan]])


def bent(kind: str) -> str:
    return STRAIGHT + BENT.replace("KIND", kind)


def test_random_words_lists_points_and_maps_are_plain_for_one_variant(sample: Sample) -> None:
    options = (
        "side: choice(left, right), sizes: [1m..2m, 3m], middle: (0m..1m, 2m), "
        "named: { first: 1m..2m }"
    )
    scenes = sample(bent(f"steps {{ {options} }}"), 8, kinds=(Steps,)).scenes
    moved = [scene.roads[1].y[0] for scene in scenes]
    assert all(4 <= abs(y) <= 5 for y in moved)
    assert {np.sign(y) for y in moved} == {-1.0, 1.0}


def test_what_is_computed_of_the_length_of_the_road_fits(sample: Sample) -> None:
    (scene,) = sample(bent("swell"), kinds=(Swell,)).scenes
    assert max(scene.roads[1].y) == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("rise", ["3m", "3m..3.001m"])
def test_constant_and_random_options_are_alike_to_a_batch_method(sample: Sample, rise: str) -> None:
    for scene in sample(bent(f"slope {{ rise: {rise} }}"), 3, kinds=(Slope,)).scenes:
        assert scene.roads[1].y[-1] == pytest.approx(3.0, abs=2e-3)


def test_a_signal_that_is_alike_in_all_variants_needs_no_rows(sample: Sample) -> None:
    text = STRAIGHT + "require short: always (milestone(main) < 201m)\n"
    assert sample(text, kinds=(Milestone,)).scenes[0].requirements[0].robustness == pytest.approx(1)


@pytest.mark.parametrize(
    ("formula", "kind", "says"),
    [
        ("always (clipped(main) < 1)", Clipped, "gave values of shape (1, 200), not ("),
        ("doubtful(main) < 1", Doubtful, "gave values that are not finite numbers"),
    ],
)
def test_signals_that_do_not_fit_are_blamed(
    sample: Sample, formula: str, kind: type[Kind], says: str
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sample(STRAIGHT + f"require fits: {formula}\n", kinds=(kind,))
    (fault,) = caught.value.diagnostics
    assert fault.code == "RL474"
    assert says in fault.message
    assert f"acme.{kind.name}" in fault.message
