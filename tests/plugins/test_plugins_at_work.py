"""A kind that fails or lies is named with its plugin; one variant at a time is enough for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import Adjuster, Length, Monitor, Perturber, RoadName, Signal, option
from roadlang.diagnostics import Diagnostic, DiagnosticError
from roadlang.plugins.kinds import Kind
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]


@dataclass(frozen=True)
class Raising(Perturber):
    """Divides by zero."""

    name: ClassVar[str] = "raising"
    size: Length = option(1.0)

    def displacements(self, roads: Any, random: Any) -> Any:
        return 1 / 0


@dataclass(frozen=True)
class Infinite(Perturber):
    """Gives what is not a number."""

    name: ClassVar[str] = "infinite"
    size: Length = option(1.0)

    def displacements(self, roads: Any, random: Any) -> Any:
        return np.full((1, len(roads.stations)), np.nan)


@dataclass(frozen=True)
class Short(Perturber):
    """Gives too few numbers."""

    name: ClassVar[str] = "short"
    size: Length = option(1.0)

    def displacements(self, roads: Any, random: Any) -> Any:
        return np.zeros((1, 3))


@dataclass(frozen=True)
class Step(Perturber):
    """Moves the whole road aside, one variant at a time."""

    name: ClassVar[str] = "step"
    size: Length = option()

    def displacement(self, road: Any, random: Any) -> Any:
        assert isinstance(self.size, float)
        return np.full(len(road.stations), self.size + random.uniform(0, 1e-3))


@dataclass(frozen=True)
class Wild(Monitor):
    """Raises while it judges."""

    name: ClassVar[str] = "wild"
    road: RoadName = option()

    def robustness(self, **signals: Any) -> Any:
        raise RuntimeError("no idea")


@dataclass(frozen=True)
class Reach(Signal):
    """Distance from the origin."""

    name: ClassVar[str] = "reach"
    unit: ClassVar[str] = "m"
    road: RoadName = option()

    def values(self) -> Any:
        return np.hypot(self.road.points[..., 0], self.road.points[..., 1])


@dataclass(frozen=True)
class Bleach(Adjuster):
    """Changes the shape of the picture."""

    name: ClassVar[str] = "bleach"

    def adjust(self, pixels: Any, random: Any) -> Any:
        return pixels[:5]


def failure(sample: Sample, text: str, kind: type[Kind]) -> Diagnostic:
    with pytest.raises(DiagnosticError) as caught:
        sample(STRAIGHT + text, kinds=(kind,))
    return caught.value.diagnostics[0]


def bent(kind: str) -> str:
    return f"road bent from main {{ perturb with {kind} }}\n"


def test_one_that_raises_is_named_with_its_reason(sample: Sample) -> None:
    found = failure(sample, bent("raising"), Raising)
    assert found.code == "RL470"
    assert "perturb acme.raising" in found.message
    assert "ZeroDivisionError: division by zero" in found.message
    assert found.span is not None
    assert found.span.line == 3


@pytest.mark.parametrize(("kind", "says"), [(Infinite, "not finite"), (Short, "(1, 3)")])
def test_wrong_results_are_blamed_on_the_pass(sample: Sample, kind: type[Kind], says: str) -> None:
    found = failure(sample, bent(kind.name), kind)
    assert found.code == "RL474"
    assert says in found.message
    assert f"acme.{kind.name}" in found.message


def test_a_monitor_that_raises_is_named(sample: Sample) -> None:
    found = failure(sample, "require calm with wild { road: main }\n", Wild)
    assert found.code == "RL470"
    assert "no idea" in found.message


def test_the_others_go_on_working(sample: Sample) -> None:
    assert sample(STRAIGHT, kinds=(Raising, Wild)).accepted == 1


def test_one_variant_at_a_time_is_enough(sample: Sample) -> None:
    text = (
        STRAIGHT
        + bent("step { size: 1m..5m }")
        + "require far: always (deviation(bent, main) > 3m)\n"
    )
    first, second = (sample(text, 8, kinds=(Step,)) for _ in range(2))
    assert first.scenes == second.scenes
    for scene in first.scenes:
        size = scene.draws["bent/perturb 1/size"]
        assert size > 2.999
        assert np.allclose(scene.roads[1].y, size, atol=1.1e-3)


def test_a_signal_of_a_plugin_is_one_like_any(sample: Sample) -> None:
    (scene,) = sample(
        STRAIGHT + "require near: always (reach(main) < 201m)\n", kinds=(Reach,)
    ).scenes
    assert scene.requirements[0].robustness == pytest.approx(1.0)


def test_the_provenance_names_the_plugins_in_use(sample: Sample) -> None:
    (scene,) = sample(STRAIGHT + bent("step { size: 1m }"), kinds=(Step, Wild)).scenes
    assert set(scene.provenance.plugins) == {"roadlang", "acme"}
