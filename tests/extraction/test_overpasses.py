"""A road drawn with a gap on both sides of another one passes over it or under it."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.drawings.surface_roads import roads_of_surface
from roadlang_standard.extraction.graphs import overpasses
from roadlang_standard.extraction.networks.found_network import FoundNetwork


def _found(*lines: tuple[tuple[int, int], tuple[int, int]], gap: int = 30) -> FoundNetwork:
    """A level road through (300, 200) of a picture, and what else is drawn."""
    surface = np.zeros((400, 600), np.float32)
    for start, end in lines:
        cv2.line(surface, start, end, 1.0, 16, cv2.LINE_AA)
    cv2.rectangle(surface, (0, 200 - gap), (599, 200 + gap), 0.0, -1)
    cv2.rectangle(surface, (0, 192), (599, 207), 1.0, -1)
    return roads_of_surface(surface, "test")


@pytest.mark.parametrize("lean", [0, 90])
def test_an_interrupted_road_goes_on_beyond_the_road_that_it_passes(lean: int) -> None:
    found = _found(((300 - lean, 20), (300 + lean, 380)))
    assert len(found.roads) == 2
    (over,) = (road for road in found.roads if np.ptp(road.points[:, 1]) > 100)
    expected = 300 + lean * (over.points[:, 1] - 200) / 180
    assert np.abs(over.points[:, 0] - expected).max() < 2
    assert np.abs(over.widths - 16).max() < 2
    assert over.confidence < 1


def test_ends_that_do_not_face_each_other_or_nothing_between_them_stay() -> None:
    aside = _found(((250, 20), (250, 200)), ((350, 200), (350, 380)))
    assert len(aside.roads) == 3
    far = _found(((300, 20), (300, 380)), gap=80)
    assert len(far.roads) == 3
    surface = np.zeros((400, 600), np.float32)
    for start, end in (((300, 20), (300, 180)), ((300, 220), (300, 380))):
        cv2.line(surface, start, end, 1.0, 16, cv2.LINE_AA)
    assert len(roads_of_surface(surface, "test").roads) == 2


def test_ends_far_apart_are_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    compared: list[object] = []
    face = overpasses._face

    def counted(*ends: Any) -> Any:
        compared.append(ends)
        return face(*ends)

    monkeypatch.setattr(overpasses, "_face", counted)
    page = np.zeros((400, 600), np.float32)
    for x in range(20, 600, 30):
        for y in range(20, 400, 40):
            cv2.line(page, (x, y), (x, y + 20), 1.0, 3)  # strokes of letters
    roads_of_surface(page, "test", least=0.0)
    strokes = len(range(20, 600, 30)) * len(range(20, 400, 40))
    assert 0 < len(compared) < 20 * strokes
