"""A fault is told of whoever made it: the plugin, the scene file, or the machine."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    Adjuster,
    Backend,
    Code,
    Diagnostic,
    DiagnosticError,
    Distribution,
    Drawer,
    Extractor,
    FoundObject,
    Kind,
    Like,
    Monitor,
    Perturber,
    Reader,
    RoadName,
    Sampler,
    Signal,
    diagnose,
    geometry,
    option,
)
from tests.straight_road import STRAIGHT

PICTURE = 'image plan from """\n####\n""" { scale: 8m/px, legend: { "#": road } }\n'
FOUND = PICTURE + "network town from plan { extract with odd }\nroad main from town\n"
BENT = STRAIGHT + "road bent from main { perturb with odd }\n"
LINE = np.array([(0.0, 0.0), (3.0, 0.0)])


def fault(text: str, *kinds: type[Kind], n: int = 1, folder: Path = Path()) -> Diagnostic:
    """The one thing that is wrong with the scenes of a text."""
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(text, n, kinds=kinds, folder=folder)
    [found] = caught.value.diagnostics
    return found


def extractor(extract: Callable[[Any], Any]) -> type[Extractor]:
    @dataclass(frozen=True)
    class Odd(Extractor):
        """Extracts as it is told to."""

        name: ClassVar[str] = "odd"

        def extract(self, picture: Any) -> Any:
            return extract(picture)

    return Odd


def perturber(displacement: Callable[[Any], Any]) -> type[Perturber]:
    @dataclass(frozen=True)
    class Odd(Perturber):
        """Displaces as it is told to."""

        name: ClassVar[str] = "odd"

        def displacement(self, road: Any, random: Any) -> Any:
            return displacement(road)

    return Odd


def distribution(quantile: Callable[[Any], Any]) -> type[Distribution]:
    @dataclass(frozen=True)
    class Odd(Distribution):
        """Draws as it is told to."""

        name: ClassVar[str] = "odd"
        low: Like = option()

        def quantile(self, uniform: Any) -> Any:
            return quantile(uniform)

    return Odd


def backend(**methods: Any) -> type[Backend]:
    members = {name: (lambda gives: lambda self, _: gives)(g) for name, g in methods.items()}
    annotations = {"name": ClassVar[str]}
    body = {"name": "odd", "__doc__": "Odd.", "__annotations__": annotations, **members}
    return dataclass(frozen=True)(type("Odd", (Backend,), body))


def raising(error: BaseException) -> Callable[[Any], Any]:
    def fail(_: Any) -> Any:
        raise error

    return fail


def test_too_little_memory_is_nobodys_bug() -> None:
    found = fault(BENT, perturber(raising(MemoryError())))
    assert found.code == Code.PLUGIN_FAILED
    assert "`perturb tested.odd` failed (tested 0): MemoryError" in found.message
    assert found.help == (
        "the machine has too little memory for this, or the plugin asks for too much",
    )


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
        (lambda u: u * 1j, "gave values that are complex numbers, not real numbers"),
        (lambda u: u[:0], "gave values of shape (0, 1), not (4, 1)"),
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
        (lambda road: 1j * road.stations, "displacements that are complex numbers"),
        (lambda road: ["a"] * len(road.stations), "displacements that are of type <U1"),
        (lambda road: [None] * len(road.stations), "displacements that are of type object"),
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


def emitted(odd: type[Backend], folder: Path) -> Diagnostic:
    scenes = testing.sample(STRAIGHT + "emit odd\n", kinds=[odd])
    with pytest.raises(DiagnosticError) as caught:
        scenes.emit(folder)
    assert not folder.exists()
    [found] = caught.value.diagnostics
    return found


@pytest.mark.parametrize(
    ("files", "says"),
    [
        ({"txt": "\udc80"}, "gave text as the content of `txt` that UTF-8 cannot hold"),
        ({"txt": 3}, "gave a int as the content of `txt`"),
        ({"../txt": ""}, "gave a file the name '../txt'"),
        ({"a/b": ""}, "gave a file the name 'a/b'"),
        ({"": ""}, "gave a file the name ''"),
        ({3: ""}, "gave a file the name 3"),
        (["txt"], "gave a list, not a map of contents"),
        (None, "gave a NoneType, not a map of contents"),
    ],
)
def test_contents_that_are_none(files: Any, says: str, tmp_path: Path) -> None:
    found = emitted(backend(files=files), tmp_path / "out")
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert says in found.message


@pytest.mark.parametrize("name", ["manifest.json", "Manifest.JSON"])
def test_the_manifest_is_roadlangs_own(name: str, tmp_path: Path) -> None:
    found = emitted(backend(collection={name: "{}"}), tmp_path / "out")
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert "is that of the manifest" in found.message


def test_a_readers_own_diagnostic_has_the_place_of_the_file(tmp_path: Path) -> None:
    @dataclass(frozen=True)
    class Odd(Reader):
        """Says what is wrong with the file."""

        name: ClassVar[str] = "odd"
        suffixes: ClassVar[tuple[str, ...]] = (".odd",)
        reads: ClassVar[tuple[str, ...]] = ("road", "network", "image")

        def read(self, path: Path) -> Any:
            raise DiagnosticError(Diagnostic("ODD01", "error", f"{path.name} has no line"))

    (tmp_path / "line.odd").write_text("nothing")
    for text, place in (
        ('road main from "line.odd"\n', '"line.odd"'),
        ('road main from "line.odd" { read with odd }\n', "read with odd"),
        ('network n from "line.odd"\nroad main from n\n', '"line.odd"'),
        (
            'image i from "line.odd" { scale: 1m/px, read with odd }\n'
            "network n from i\nroad r from n\n",
            "read with odd",
        ),
    ):
        found = fault(text, Odd, folder=tmp_path)
        assert found.code == "ODD01"
        assert found.span is not None
        assert place in found.span.text


def test_a_plugin_that_changes_the_folder_changes_no_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "elsewhere").mkdir()

    def go(road: Any) -> Any:
        os.chdir(tmp_path / "elsewhere")
        return 0 * road.stations

    scenes = testing.sample(BENT + "emit json\n", kinds=[perturber(go)])
    os.chdir(tmp_path)
    goes = backend(files={})

    def files(self: Any, scene: Any) -> Any:
        os.chdir(tmp_path / "elsewhere")
        return {"txt": ""}

    goes.files = files  # type: ignore[method-assign]
    scenes = testing.sample(STRAIGHT + "emit json\nemit odd\n", kinds=[goes])
    scenes.emit("out")
    assert (tmp_path / "out" / "scene-0000.json").exists()
    assert not (tmp_path / "elsewhere" / "out").exists()


def test_diagnostics_of_a_plugin_may_use_our_codes() -> None:
    found = fault(
        BENT, perturber(raising(DiagnosticError(diagnose(Code.GRID_TOO_LARGE, most="3"))))
    )
    assert found.code == Code.GRID_TOO_LARGE
    assert found.span is not None
