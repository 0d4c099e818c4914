"""Drawings whose colored spots may be objects: a legend is proposed, which then finds them."""

from __future__ import annotations

import re

import cv2
import numpy as np
import pytest

from roadlang.api import DiagnosticError, Picture
from roadlang_standard.extract_auto import Auto

GREEN, RED = (46, 125, 50), (211, 47, 47)


def drawn(*spots: tuple[int, int, tuple[int, int, int]], line: int = cv2.LINE_AA) -> np.ndarray:
    """A crossing with disks at these places, all edges smooth."""
    image = np.full((300, 420, 3), 255, np.uint8)
    cv2.line(image, (0, 90), (419, 130), (0, 0, 0), 14, line)
    cv2.line(image, (210, 110), (230, 299), (0, 0, 0), 14, line)
    for x, y, color in spots:
        cv2.circle(image, (x, y), 10, color[::-1], -1, line)
    return image


SPOTS = ((60, 200, GREEN), (110, 250, GREEN), (330, 220, RED))


def proposals(image: np.ndarray) -> list[str]:
    found = Auto().extract(Picture(image, 0.5))
    return [remark for remark in found.remarks if "legend" in remark]


@pytest.mark.parametrize("line", [cv2.LINE_AA, cv2.LINE_8])
def test_the_proposed_legend_finds_the_spots(line: int) -> None:
    image = drawn(*SPOTS, line=line)
    (said,) = proposals(image)
    assert "2 of #2e7d32, 1 of #d32f2f" in said
    legend = dict(re.findall(r'"(#\w{6})": (\w+)', said))
    assert legend == {"#000000": "road", "#2e7d32": "tree", "#d32f2f": "cone"}
    found = Auto().extract(Picture(image, 0.5, legend=legend))
    at = sorted((item.kind, round(item.x), round(item.y)) for item in found.objects)
    expected = [(color, (x + 0.5) / 2.0, (300 - 0.5 - y) / 2.0) for x, y, color in SPOTS]
    kinds = {GREEN: "tree", RED: "cone"}
    wanted = sorted((kinds[color], x, y) for color, x, y in expected)
    assert [kind for kind, _, _ in at] == [kind for kind, _, _ in wanted]
    for (_, x, y), (_, a, b) in zip(at, wanted, strict=True):
        assert np.hypot(x - a, y - b) < 1.0
    assert len(found.network.edges) == 3


def test_a_drawing_of_roads_alone_is_left_alone() -> None:
    assert proposals(drawn()) == []


def test_lines_of_another_color_are_no_spots() -> None:
    image = drawn()
    cv2.line(image, (20, 40), (400, 50), RED[::-1], 4)
    assert proposals(image) == []


def test_single_pixels_of_a_color_are_still_objects() -> None:
    """As in drawings of one pixel a cell."""
    image = np.full((9, 9, 3), 255, np.uint8)
    image[4] = 0
    image[1, 2] = image[7, 6] = RED[::-1]
    found = Auto().extract(Picture(image, 4.0, legend={"black": "road", "#d32f2f": "cone"}))
    assert len(found.objects) == 2


@pytest.mark.parametrize(
    ("legend", "said"),
    [
        ({"#2e7d32": "tree"}, 'add `"#000000": road` to the legend'),
        ({"black": "building"}, 'such as `"white": road`'),  # already an object
    ],
)
def test_a_legend_without_road_is_told_the_color_of_the_roads(
    legend: dict[str, str], said: str
) -> None:
    with pytest.raises(DiagnosticError) as raised:
        Auto().extract(Picture(drawn(*SPOTS), 0.5, legend=legend))
    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.code == "RL421"
    assert said in " ".join(diagnostic.help)
