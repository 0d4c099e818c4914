"""A fault is blamed on whoever made it: the plugin, the scene file, or the machine."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar, cast

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    Adjuster,
    Code,
    DiagnosticError,
    Drawer,
    FoundObject,
    Monitor,
    RoadName,
    Sampler,
    Signal,
    geometry,
    option,
)
from tests.plugins.odd_kinds import (
    BENT,
    FOUND,
    LINE,
    distribution,
    extractor,
    fault,
    perturber,
    raising,
)
from tests.straight_road import STRAIGHT


def test_too_little_memory_is_nobodys_bug() -> None:
    found = fault(BENT, perturber(raising(MemoryError())))
    assert found.code == Code.PLUGIN_FAILED
    assert "`perturb tested.odd` failed (tested 0): MemoryError" in found.message
    assert found.help == (
        "the machine has too little memory for this, or the plugin asks for too much",
    )


class Unreadable(Exception):
    """Its message cannot be read."""

    def __str__(self) -> str:
        raise KeyError("text")


@pytest.mark.parametrize(
    ("raises", "says"),
    [
        (lambda road: DiagnosticError(cast(Any, [])), "TypeError: a DiagnosticError takes"),
        (lambda road: DiagnosticError(), "TypeError: a DiagnosticError takes"),
        (raising(Unreadable()), "Unreadable: its message cannot be read: KeyError"),
    ],
)
def test_exceptions_that_are_wrong_themselves_are_faults_of_the_plugin(
    raises: Callable[[Any], Any], says: str
) -> None:
    found = fault(BENT, perturber(raises))
    assert found.code == Code.PLUGIN_FAILED
    assert f"`perturb tested.odd` failed (tested 0): {says}" in found.message


def test_a_fault_says_the_line_of_the_plugin() -> None:
    found = fault(BENT, perturber(lambda road: 1 / 0))
    assert "ZeroDivisionError: division by zero (test" in found.message


@pytest.mark.parametrize(
    ("lines", "width", "says"),
    [
        ([LINE * np.nan], None, "the points of polyline 0 must be finite numbers"),
        ([LINE, LINE[:1]], None, "polyline 1 has 1 point: it needs two or more"),
        ([LINE[:0]], None, "polyline 0 has 0 points: it needs two or more"),
        ([LINE[:, :1]], None, "the points of polyline 0 must be pairs (x, y)"),
        ([["a", "b"]], None, "the points of polyline 0 must be numbers"),
        ([LINE], -1.0, "a width must be positive, but it is -8 m"),
        ([LINE], float("nan"), "a width must be positive, but it is nan m"),
        ([LINE[[0, 0]]], None, "GeometryError"),
    ],
)
def test_polylines_that_are_none_are_the_extractors_fault(
    lines: Any, width: float | None, says: str
) -> None:
    found = fault(FOUND, extractor(lambda picture: picture.network(lines, width=width)))
    assert found.code == Code.PLUGIN_FAILED
    assert "`extract tested.odd` failed (tested 0): GeometryError" in found.message
    assert says in found.message
    assert found.span is not None


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"network": None}, "gave an extraction of a NoneType, not of a RoadNetwork"),
        ({"confidence": float("nan")}, "gave the confidence nan"),
        ({"confidence": 1.5}, "gave the confidence 1.5, which is not within [0, 1]"),
        ({"confidence": "high"}, "gave the confidence 'high'"),
        ({"objects": ("tree",)}, "gave objects that are not FoundObjects"),
    ],
)
def test_an_extraction_with_parts_that_are_none(change: dict[str, Any], says: str) -> None:
    odd = extractor(lambda picture: replace(picture.network([LINE], width=1.0), **change))
    found = fault(FOUND, odd)
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert says in found.message


def test_an_extraction_that_is_one() -> None:
    thing = FoundObject("tree", 1.0, 2.0, 3.0, 4.0)
    odd = extractor(lambda picture: replace(picture.network([LINE]), objects=(thing,)))
    assert testing.sample(FOUND, kinds=[odd])


def test_geometry_that_the_scene_asks_for_is_the_scenes_fault() -> None:
    @dataclass(frozen=True)
    class Dot(Drawer):
        """Draws a point."""

        name: ClassVar[str] = "odd"

        def draw(self, closed: bool) -> Any:
            return geometry.Curve.through([(0.0, 0.0)])

    assert fault("road main { draw with odd }\n", Dot).code == Code.IMPOSSIBLE_GEOMETRY


class GeometryError(ValueError):
    """An error of the plugin's own that happens to be called as one of ours."""


def test_an_error_that_has_the_name_of_ours_is_the_plugins() -> None:
    found = fault(BENT, perturber(raising(GeometryError("no idea"))))
    assert found.code == Code.PLUGIN_FAILED


@pytest.mark.parametrize("road", ["draw", "perturb"])
def test_geometry_errors_of_an_adjuster_are_the_plugins(road: str) -> None:
    @dataclass(frozen=True)
    class Odd(Adjuster):
        """Computes with roads, of all things."""

        name: ClassVar[str] = "odd"

        def adjust(self, pixels: Any, random: Any) -> Any:
            raise geometry.GeometryError("no such road")

    picture = Path(__file__).parents[2] / "examples" / "hairpin.jpg"
    text = f'image photo from "{picture}" {{ scale: 1m/px, adjust with odd }}\n'
    found = fault(text + "network n from photo\nroad main from n\n", Odd)
    assert found.code == Code.PLUGIN_FAILED


@pytest.mark.parametrize(
    ("quantile", "says"),
    [
        (lambda u: u * np.nan, "gave values that are not finite numbers"),
        (lambda u: u * np.inf, "gave values that are not finite numbers"),
        (lambda u: u * 1j, "gave values as complex numbers, not as real numbers"),
        (lambda u: u[:0], "gave values of shape (0, 1), not (4, 1)"),
        (lambda u: None, "gave values as None, not as real numbers"),
        (lambda u: [None] * len(u), "gave values as None, not as real numbers"),
        (lambda u: "wide", "gave values as text, not as real numbers"),
        (lambda u: b"wide", "gave values as bytes, not as real numbers"),
    ],
)
def test_a_distribution_whose_values_are_no_numbers(
    quantile: Callable[[Any], Any], says: str
) -> None:
    text = STRAIGHT + (
        "let size = odd(1m)\n"
        "road bent from main { perturb with sine { amplitude: size, wavelength: 80m } }\n"
    )
    found = fault(text, distribution(quantile))
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert "`distribution tested.odd`" in found.message
    assert says in found.message


def test_objects_that_are_numbers_may_be_drawn() -> None:
    text = STRAIGHT + "param size = odd(1m)\nroad wide from main { width: size }\n"
    odd = distribution(lambda u: np.array([[6] for _ in u], dtype=object))
    (scene,) = testing.sample(text, kinds=[odd])
    assert scene.roads["wide"].width == pytest.approx(6.0)


def test_what_is_not_a_number_by_the_scenes_own_doing_is_the_scenes_fault() -> None:
    text = STRAIGHT + (
        "let none = 0m..1m\n"
        "let size = (none - none) / (none - none) * 1m\n"
        "road bent from main { perturb with sine { amplitude: size, wavelength: 80m } }\n"
    )
    assert fault(text).code == Code.NON_FINITE_VALUE


@pytest.mark.parametrize(
    ("displacement", "says"),
    [
        (lambda road: 1j * road.stations, "displacements as complex numbers"),
        (lambda road: ["a"] * len(road.stations), "displacements as text"),
        (lambda road: [None] * len(road.stations), "displacements as None"),
    ],
)
def test_displacements_that_are_no_real_numbers(
    displacement: Callable[[Any], Any], says: str
) -> None:
    found = fault(BENT, perturber(displacement))
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert says in found.message


def test_whole_numbers_and_truth_values_are_numbers() -> None:
    (scene,) = testing.sample(BENT, kinds=[perturber(lambda road: [1] * len(road.stations))])
    assert scene.roads["bent"].y == pytest.approx(1.0)


def test_complex_values_of_other_kinds() -> None:
    @dataclass(frozen=True)
    class OddSignal(Signal):
        """Complex."""

        name: ClassVar[str] = "odd"
        road: RoadName = option()

        def values(self) -> Any:
            return 1j * self.road.stations

    @dataclass(frozen=True)
    class OddMonitor(Monitor):
        """Complex."""

        name: ClassVar[str] = "odd"

        def robustness(self) -> Any:
            return [1j]

    @dataclass(frozen=True)
    class OddSampler(Sampler):
        """Complex."""

        name: ClassVar[str] = "odd"

        def points(self, indices: Any, draws: Any, seed: Any) -> Any:
            return np.full((len(indices), len(draws)), 1j)

    drawn = STRAIGHT + (
        "road bent from main { perturb with sine { amplitude: 0m..1m, wavelength: 80m } }\n"
    )
    for text, kind in (
        (STRAIGHT + "require r: always (odd(main) < 1)\n", OddSignal),
        (STRAIGHT + "require r with odd\n", OddMonitor),
        (drawn + "sample with odd\n", OddSampler),
    ):
        found = fault(text, kind)
        assert found.code == Code.WRONG_PLUGIN_RESULT
        assert "complex numbers" in found.message


@pytest.mark.parametrize(
    "odd", [lambda n, d: np.zeros((n, d + 1)), lambda n, d: np.zeros((n + 1, d)),
            lambda n, d: np.zeros(n * d), lambda n, d: np.full((n, d), 1.01),
            lambda n, d: np.full((n, d), -0.01)],
    ids=["a column more", "a row more", "flat", "above 1", "below 0"],
)  # fmt: skip
def test_points_of_a_sampler_are_a_row_for_each_index_within_the_unit_cube(odd: Any) -> None:
    @dataclass(frozen=True)
    class OddSampler(Sampler):
        """Points where none can be."""

        name: ClassVar[str] = "odd"

        def points(self, indices: Any, draws: Any, seed: Any) -> Any:
            return odd(len(indices), len(draws))

    text = STRAIGHT + (
        "road bent from main { perturb with sine { amplitude: 0m..1m, wavelength: 80m } }\n"
    )
    found = fault(text + "sample with odd\n", OddSampler)
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert "gave points of shape" in found.message
