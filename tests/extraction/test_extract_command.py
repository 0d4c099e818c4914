"""`roadlang extract`: JSON in pixels, an overlay, a mask."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from click.testing import CliRunner

from roadlang.api import Extraction, Picture
from roadlang.cli.extract import command
from roadlang.cli.extraction_files import as_json, as_mask, as_overlay
from roadlang.diagnostics import DiagnosticError
from roadlang.geometry import Curve, Edge, Node, RoadNetwork
from training.rendering.drawings import draw_circuit


@pytest.fixture
def circuit(tmp_path: Path) -> Any:
    drawn = draw_circuit(3, 400)
    cv2.imwrite(str(tmp_path / "circuit.png"), drawn.image)
    return drawn, tmp_path


def run(*words: Any) -> Any:
    return CliRunner().invoke(command, [str(word) for word in words])


def test_roads_are_written_in_pixels(circuit: Any, distance_to: Any) -> None:
    drawn, folder = circuit
    names = [folder / name for name in ("roads.json", "roads.svg", "mask.png")]
    done = run(folder / "circuit.png", "-o", names[0], "--overlay", names[1], "--mask", names[2])
    assert done.exit_code == 0, done.output
    document = json.loads(names[0].read_text())
    (line,) = document["polylines"]
    assert line[0] == line[-1]
    assert distance_to(np.array(line), drawn.truth.roads[0].points).max() < 1.5
    assert document["mask"] == "mask.png"
    assert document["roads"][0]["closed"]
    assert cv2.imread(str(names[2]), 0).shape == (400, 400)
    assert names[1].read_text().startswith("<svg")


def test_each_stretch_of_a_road_says_how_sure_it_is() -> None:
    picture = Picture(np.full((40, 200, 3), 90, np.uint8), 0.5)
    curve = Curve.through(
        picture.to_world(np.column_stack([np.arange(10, 191, 10), np.full(19, 20)]))
    )
    nodes = (Node(0, tuple(curve.at(0.0))), Node(1, tuple(curve.at(curve.length))))
    network = RoadNetwork(nodes, (Edge(1, 0, 1, curve, np.array([4.0]), 0.6),))
    found = Extraction(network, confidence=0.6, confidences=(np.repeat([1.0, 0.2], 50),))
    (road,) = json.loads(as_json(picture, found, True, 0.0, None))["roads"]
    assert len(road["confidences"]) == len(road["widths"])
    assert (road["confidences"][0], road["confidences"][-1]) == (1.0, 0.2)
    colors = re.findall(
        r'stroke="(#\w+)" stroke-width="1.6"><title>(\d+)% sure here', as_overlay(picture, found)
    )
    assert colors[0] == ("#00e5ff", "99")
    assert colors[-1] == ("#ee6223", "20")


def one_road(mask: Any = None) -> tuple[Picture, Extraction]:
    """A road 6 pixels wide, from west to east."""
    picture = Picture(np.full((40, 200, 3), 90, np.uint8), 0.5)
    points = np.column_stack([np.arange(10, 191, 10), np.full(19, 20)])
    curve = Curve.through(picture.to_world(points))
    nodes = (Node(0, tuple(curve.at(0.0))), Node(1, tuple(curve.at(curve.length))))
    network = RoadNetwork(nodes, (Edge(1, 0, 1, curve, np.array([3.0])),))
    return picture, Extraction(network, mask=mask)


def test_the_mask_is_that_of_the_extractor_where_it_has_one() -> None:
    surface = np.zeros((40, 200), bool)
    surface[5:9, 50:80] = True
    picture, found = one_road(surface)
    drawn = cv2.imdecode(np.frombuffer(as_mask(picture, found), np.uint8), 0)
    assert ((drawn == 255) == surface).all()


@pytest.mark.parametrize("mask", [None, np.ones((20, 100), bool)])
def test_a_mask_is_drawn_along_the_roads_where_there_is_none_of_that_size(mask: Any) -> None:
    picture, found = one_road(mask)
    drawn = cv2.imdecode(np.frombuffer(as_mask(picture, found), np.uint8), 0)
    assert drawn.shape == (40, 200)
    across = np.flatnonzero(drawn[:, 100])
    assert (across.min(), across.max()) == pytest.approx((17, 23), abs=1)
    along = np.flatnonzero(drawn[20])
    assert (along.min(), along.max()) == pytest.approx((10, 190), abs=4)


def test_without_an_output_the_json_goes_to_standard_output(circuit: Any) -> None:
    _, folder = circuit
    assert json.loads(run(folder / "circuit.png").output)["schema"] == "roadlang.extraction/1"


def test_a_picture_without_a_road_is_an_error(tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "blank.png"), np.full((80, 80, 3), 200, np.uint8))
    done = run(tmp_path / "blank.png", "-o", tmp_path / "roads.json")
    assert done.exit_code == 1
    assert "RL427" in done.output


def test_unknown_kinds_and_unfit_options_are_explained(circuit: Any) -> None:
    _, folder = circuit
    for words, code in (
        (["--with", "ariel"], "RL425"),
        (["--with", "pixels", "--through", "1,2"], "RL426"),
    ):
        done = run(folder / "circuit.png", *words)
        assert isinstance(done.exception, DiagnosticError)
        assert done.exception.diagnostics[0].code == code


def test_a_scale_changes_no_number_in_pixels(circuit: Any) -> None:
    _, folder = circuit
    plain = json.loads(run(folder / "circuit.png").output)["roads"][0]
    scaled = json.loads(run(folder / "circuit.png", "--scale", "0.25").output)["roads"][0]
    assert plain["length"] == pytest.approx(scaled["length"], rel=1e-6)
    assert plain["widths"] == pytest.approx(scaled["widths"], abs=0.02)


@pytest.mark.parametrize(("words", "scale"), [((), 0.25), (("--scale", "0.5"), 0.5)])
def test_a_world_file_gives_the_scale_unless_another_is_said(
    circuit: Any, words: tuple[str, ...], scale: float
) -> None:
    _, folder = circuit
    (folder / "circuit.pgw").write_text("0.25\n0\n0\n-0.25\n0\n0\n")
    result = run(folder / "circuit.png", "-o", folder / "roads.json", *words)
    assert result.exit_code == 0, result.output
    assert json.loads((folder / "roads.json").read_text())["meters_per_pixel"] == scale


def test_each_file_is_written_only_where_it_is_asked_for(circuit: Any) -> None:
    _, folder = circuit
    before = set(folder.iterdir())
    document = json.loads(run(folder / "circuit.png", "--mask", folder / "mask.png").stdout)
    assert set(folder.iterdir()) - before == {folder / "mask.png"}
    assert document["mask"].endswith("mask.png")
    done = run(folder / "circuit.png", "--overlay", folder / "seen.svg", "-o", folder / "it.json")
    assert set(folder.iterdir()) - before == {
        folder / name for name in ("mask.png", "seen.svg", "it.json")
    }
    assert "1 road (" in done.output
    assert "schema" not in done.output


@pytest.mark.parametrize(
    ("option", "fault"),
    [("-o", "this writes JSON or GeoJSON"), ("--mask", "circuit.png would overwrite")],
)
def test_the_picture_is_never_written_over(circuit: Any, option: str, fault: str) -> None:
    picture = circuit[1] / "circuit.png"
    before = picture.read_bytes()
    done = run(picture, option, picture)
    assert done.exit_code == 2
    assert fault in done.output
    assert picture.read_bytes() == before


def test_places_are_finite_numbers(circuit: Any) -> None:
    done = run(circuit[1] / "circuit.png", "--through", "nan,1")
    assert done.exit_code == 2
    assert "'nan,1' is not X,Y" in done.output


def test_an_option_that_a_kind_requires_is_asked_for(circuit: Any) -> None:
    done = run(circuit[1] / "circuit.png", "--with", "onnx")
    assert done.exit_code == 2
    assert "`--with onnx` needs `model`: give `--model`." in done.output


@pytest.mark.parametrize("name", ["roads.png", "roads.svg", "roads.xodr", "roads.csv"])
def test_roads_are_not_written_under_the_name_of_another_format(circuit: Any, name: str) -> None:
    _, folder = circuit
    done = run(folder / "circuit.png", "-o", folder / name)
    assert done.exit_code == 2
    assert "this writes JSON or GeoJSON: name a file that ends in `.json`" in done.output
    assert "--overlay" in done.output
    assert not (folder / name).exists()


def test_what_else_is_remarked_of_a_picture_is_shown(tmp_path: Path) -> None:
    town = Path(__file__).parents[2] / "examples" / "town.png"
    done = run(town, "-o", tmp_path / "roads.json")
    assert done.exit_code == 0, done.output
    assert "note: there are spots of other colors (6 of #b71c1c)" in done.output
    assert "`legend: {" in done.output


LOADED = """
import sys
from roadlang.cli.chosen_extractor import _load
_load()
print("numpy.f2py.crackfortran" in sys.modules, "numpy.ma.core" in sys.modules)
"""


def test_parts_of_numpy_that_no_extractor_uses_are_not_loaded() -> None:
    found = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True)
    assert found.stdout == "False True\n", found.stderr
