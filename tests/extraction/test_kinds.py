"""The extract kinds on pictures, as the compiler calls them."""

from __future__ import annotations

import shutil
from importlib.resources import files
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.ir.picture import Picture
from roadlang_standard.extract_aerial import Aerial
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extract_contour import Contour
from roadlang_standard.extract_onnx import OnnxExtractor
from roadlang_standard.extract_pixels import Pixel
from roadlang_standard.extraction.drawings import thresholding
from roadlang_standard.extraction.drawings.drawing import between_lines
from roadlang_standard.extraction.picture_kinds import picture_kind
from tests.cli.command_lines import roadlang
from training.rendering.aerial import render_aerial
from training.rendering.drawings import draw_circuit, draw_filled

WEIGHTS = files("roadlang_standard.extraction.photos") / "weights" / "roads.onnx"


def test_auto_says_what_it_took_the_picture_for() -> None:
    drawing = Auto().extract(Picture(draw_circuit(1, 400).image, 0.5))
    typed = Auto().extract(Picture(None, 8.0, {"#": "road"}, ("###", "#..")))
    photo = Auto().extract(Picture(render_aerial("curve", 901, 256).image, 1.0))
    assert drawing.remarks[0] == "read as an edge-line drawing"
    assert typed.remarks[0] == "read as a typed grid"
    assert photo.remarks[0] == "read as a photo"


def test_edge_lines_are_sought_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """To seek them takes as long as all else: what a drawing is read as tells what it is."""
    sought: list[str] = []

    def between(*given: Any) -> Any:
        sought.append("edge lines")
        return between_lines(*given)

    monkeypatch.setattr(thresholding, "between_lines", between)
    monkeypatch.setattr(picture_kind, "has_edge_lines", lambda ink: between(ink) is not None)
    filled = Auto().extract(Picture(draw_filled("suburb", 1).image, 1.0))
    assert filled.remarks[0] == "read as a filled drawing"
    circuit = Auto().extract(Picture(draw_circuit(1, 400).image, 1.0))
    assert circuit.remarks[0] == "read as an edge-line drawing"
    assert len(sought) == 2


def test_a_circuit_comes_out_closed_and_in_meters() -> None:
    drawn = draw_circuit(2, 400)
    found = Contour().extract(Picture(drawn.image, 0.5))
    (edge,) = found.network.edges
    assert edge.curve.closed
    true = drawn.truth.roads[0]
    assert edge.length == pytest.approx(
        0.5 * np.hypot(*np.diff(true.points, axis=0).T).sum(), rel=0.02
    )


def test_the_world_has_y_up_and_its_origin_at_the_lower_left() -> None:
    found = Pixel().extract(Picture(None, 10.0, {"#": "road"}, ("###", "...")))
    (edge,) = found.network.edges
    assert edge.curve.at([0, 10, 20]).tolist() == [[5, 15], [15, 15], [25, 15]]


@pytest.mark.parametrize(
    ("kind", "picture", "code"),
    [
        (Contour(), Picture(None, 1.0, {"#": "road"}, ("##",)), "RL420"),
        (Pixel(), Picture(None, 1.0, {"T": "tree"}, ("T#",)), "RL421"),
        (Pixel(), Picture(None, 1.0, {"##": "road"}, ("##",)), "RL422"),
        (Pixel(), Picture(np.zeros((9, 9, 3), np.uint8), 1.0, {"gren": "road"}), "RL423"),
    ],
)
def test_wrong_pictures_are_explained(kind: Any, picture: Any, code: str) -> None:
    with pytest.raises(DiagnosticError) as raised:
        kind.extract(picture)
    assert [d.code for d in raised.value.diagnostics] == [code]


def test_a_net_of_ones_own_is_used_like_the_shipped_one(tmp_path: Path) -> None:
    shutil.copy(str(WEIGHTS), tmp_path / "mine.onnx")
    picture = Picture(render_aerial("curve", 902, 256).image, 1.0)
    ours, theirs = (
        Aerial().extract(picture),
        OnnxExtractor(model=str(tmp_path / "mine.onnx")).extract(picture),
    )
    lengths = [edge.length for edge in ours.network.edges]
    # OpenCV 4 lays out a net that it has not yet run otherwise, which moves the last bits.
    assert [edge.length for edge in theirs.network.edges] == pytest.approx(lengths, rel=1e-6)


def test_what_is_no_net_is_refused(tmp_path: Path) -> None:
    (tmp_path / "not.onnx").write_bytes(b"not a net at all")
    picture = Picture(np.zeros((64, 64, 3), np.uint8), 1.0)
    with pytest.raises(DiagnosticError) as raised:
        OnnxExtractor(model=str(tmp_path / "not.onnx")).extract(picture)
    assert raised.value.diagnostics[0].code == "RL424"


def test_photos_are_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROADLANG_CACHE", str(tmp_path))
    picture = Picture(render_aerial("curve", 902, 200).image, 1.0)
    first = Aerial().extract(picture)
    assert len(list(tmp_path.iterdir())) == 1
    monkeypatch.setattr("roadlang_standard.extraction.photos.cache.checked_roads", None)
    again = Aerial().extract(picture)
    assert [e.curve.points.tolist() for e in first.network.edges] == [
        e.curve.points.tolist() for e in again.network.edges
    ]


@pytest.mark.parametrize("shape", [(2, 2), (1, 300), (40, 3)])
@pytest.mark.parametrize("kind", [Auto(), Contour(), Aerial()])
def test_absurd_pictures_do_no_harm(shape: tuple[int, int], kind: Any) -> None:
    rng = np.random.default_rng(1)
    for pixels in (np.zeros((*shape, 3), np.uint8), rng.integers(0, 256, (*shape, 3), np.uint8)):
        kind.extract(Picture(pixels, 1.0))


@pytest.mark.parametrize(("share", "code"), [("60%", 0), ("100%", 3)])
def test_a_requirement_can_ask_for_confidence(tmp_path: Path, share: str, code: int) -> None:
    cv2.imwrite(str(tmp_path / "plan.png"), draw_filled("curve", 1, 200).image)
    scene = f"""
image plan from "plan.png" {{ scale: 1m/px }}
network town from plan
require sure: confidence(town) > {share}
"""
    (tmp_path / "town.rl").write_text(scene)
    assert roadlang("compile", "town.rl", "-n", "1", "-o", "out", cwd=tmp_path).returncode == code


def test_a_typed_road_has_the_width_that_is_asked_for() -> None:
    """A cell of 30 m is no road of 30 m."""
    typed = Picture(None, 30.0, {"#": "road"}, ("#####",))
    for width, expected in ((None, 30.0), (7.0, 7.0)):
        (road,) = Auto(width=width).extract(typed).network.edges
        assert float(road.width.at(60.0)) == pytest.approx(expected)
