"""The roads of a picture, in pixels for the page, beside a picture of which they are known."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from roadlang.correcting.picture_roads import PictureRoads
from roadlang.diagnostics import DiagnosticError
from roadlang.syntax.correction_edits import WrittenCorrections

SCENE = """image photo from "plan.png" {{ scale: {scale}m/px }}
image other from "other.png" {{ scale: 1m/px }}
network else_where from other {{ extract with contour }}
network town from photo {{
  extract with contour
{corrections}}}
"""


def picture_roads(folder: Path, corrections: str = "", scale: float = 0.5) -> PictureRoads:
    """Of a picture with two straight roads, 9 pixels wide, in rows 60 and 180."""
    plan = np.full((240, 400, 3), 255, np.uint8)
    for row in (60, 180):
        plan[row - 4 : row + 5] = 0
    cv2.imwrite(str(folder / "plan.png"), plan)
    cv2.imwrite(str(folder / "other.png"), np.ascontiguousarray(plan[:120]))
    (folder / "a.rl").write_text(SCENE.format(scale=scale, corrections=corrections))
    return PictureRoads.of(folder / "a.rl", folder / "plan.png")


@pytest.mark.parametrize("scale", [0.25, 1.0, 3.0])
def test_roads_are_in_pixels_whatever_the_scale(tmp_path: Path, scale: float) -> None:
    roads = picture_roads(tmp_path, scale=scale).found_roads()
    assert len({road["id"] for road in roads}) == 2
    rows = sorted(float(np.mean(road["points"], axis=0)[1]) for road in roads)
    assert rows == pytest.approx([60.5, 180.5], abs=1.0)
    for road in roads:
        assert road["width"] == pytest.approx(9.0, abs=1.0)
        assert 0.0 < road["confidence"] <= 1.0
        steps = np.hypot(*np.diff(road["points"], axis=0).T)
        assert 1.0 < steps.mean() < 3.0


def test_numbers_for_the_page_are_short(tmp_path: Path) -> None:
    roads = picture_roads(tmp_path)
    edge = roads.network.edges[0]
    widths, confidence = np.full_like(edge.widths, 2.71828), 0.98765
    (road,) = replace(
        roads, network=SimpleNamespace(edges=[replace(edge, widths=widths, confidence=confidence)])
    ).found_roads()
    assert (road["width"], road["confidence"]) == (5.44, 0.988)
    assert all(number == round(number, 1) for point in road["points"] for number in point)


def test_a_closed_road_ends_on_the_page_where_it_begins(tmp_path: Path) -> None:
    plan = np.full((240, 240, 3), 255, np.uint8)
    cv2.circle(plan, (120, 120), 80, (0, 0, 0), 9)
    cv2.imwrite(str(tmp_path / "plan.png"), plan)
    text = 'image photo from "plan.png" { scale: 1m/px }\nnetwork town from photo\n'
    (tmp_path / "a.rl").write_text(text)
    (road,) = PictureRoads.of(tmp_path / "a.rl", tmp_path / "plan.png").found_roads()
    assert road["points"][0] == road["points"][-1]


def test_corrections_of_the_file_are_those_of_the_picture_that_is_asked_for(
    tmp_path: Path,
) -> None:
    roads = picture_roads(tmp_path, "  dismissed: [[(0px, 180px), (399px, 180px)]]\n")
    assert roads.name == "town"
    written = roads.written()
    assert written == WrittenCorrections(dismissed=(((0.0, 180.0), (399.0, 180.0)),))
    (left,) = roads.roads(written)["roads"]
    assert np.mean(left["points"], axis=0)[1] == pytest.approx(60.5, abs=1.0)
    assert len(roads.found_roads()) == 2
    assert len(roads.roads(WrittenCorrections())["roads"]) == 2


def test_a_file_without_corrections_has_none(tmp_path: Path) -> None:
    assert picture_roads(tmp_path).written() == WrittenCorrections()


def test_points_that_no_road_is_near_are_told_in_pixels(tmp_path: Path) -> None:
    roads = picture_roads(tmp_path)
    shown = roads.roads(WrittenCorrections(confirmed=((200.0, 60.0), (200.0, 120.0))))
    assert shown["missed"] == [[200.0, 120.0]]
    assert roads.roads(WrittenCorrections(confirmed=((200.0, 60.0),)))["missed"] == []


def test_a_road_that_cannot_be_drawn_is_explained(tmp_path: Path) -> None:
    twice = WrittenCorrections(drawn=(((5.0, 9.0), (5.0, 9.0)),))
    assert picture_roads(tmp_path).roads(twice)["error"].startswith("This road cannot be drawn: ")


def test_what_is_saved_is_read_again(tmp_path: Path) -> None:
    roads = picture_roads(tmp_path)
    drawn = WrittenCorrections(drawn=(((200.0, 60.0), (200.0, 180.0)),))
    roads.save(drawn)
    assert roads.written() == drawn


def test_a_picture_that_no_network_is_from_is_refused(tmp_path: Path) -> None:
    picture_roads(tmp_path)
    with pytest.raises(DiagnosticError) as refused:
        PictureRoads.of(tmp_path / "a.rl", tmp_path / "third.png")
    assert [found.code for found in refused.value.diagnostics] == ["RL440"]
