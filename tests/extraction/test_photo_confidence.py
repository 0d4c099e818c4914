"""Confidence of roads of photos: about the share of their length that is right."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang_standard.extraction.networks.found_network import FoundNetwork, FoundRoad
from roadlang_standard.extraction.photos.chroma import mean_chroma
from roadlang_standard.extraction.photos.photo_confidence import CHROMA, calibrated


def _seen(
    side: int, *roads: tuple[int, int, float], width: float = 8.0, fading: bool = False
) -> FoundNetwork:
    """Roads (start, end, evidence) of 300 pixels each."""
    line = np.column_stack([np.linspace(0.0, 300.0, 151), np.full(151, 10.0)])
    found = []
    for start, end, sure in roads:
        along = np.linspace(sure, 0.1, 151) if fading else np.full(151, sure)
        mean = float(along.mean())
        found.append(FoundRoad(start, end, line, np.full(151, width), 0.0, mean, 0.0, along))
    return FoundNetwork(np.zeros((20, 2)), tuple(found), np.zeros((side, side), bool))


def _sure(found: FoundNetwork, doubt_alone: bool = True) -> list[float]:
    return [road.confidence for road in calibrated(found, doubt_alone).roads]


def test_a_faint_road_is_not_sure_where_the_picture_shows_nothing_else() -> None:
    (only,) = _sure(_seen(320, (0, 1, 0.62)))
    joined = _sure(_seen(320, (0, 1, 0.62), (1, 2, 0.62), (2, 3, 0.95)))
    beside, *_ = _sure(_seen(320, (0, 1, 0.62), *((k, k + 1, 0.9) for k in range(2, 5))))
    assert only < 0.5
    assert joined[:2] == [pytest.approx(0.75, abs=0.02)] * 2
    assert beside == joined[0]
    assert _sure(_seen(320, (0, 1, 0.62)), doubt_alone=False) == joined[:1]


def test_many_faint_roads_are_not_sure_where_none_is_clear() -> None:
    """Veins of a leaf and a cobweb are as long as the roads of a town, and faint all over."""
    web = _seen(320, *((k, k + 1, 0.5) for k in range(7)))
    assert max(_sure(web)) < 0.5
    assert min(_sure(web, doubt_alone=False)) > 0.6
    rows = _seen(320, *((2 * k, 2 * k + 1, 0.8) for k in range(9)))
    assert max(_sure(rows)) < 0.6 < min(_sure(_seen(320, *((k, k + 1, 0.8) for k in range(3)))))
    network = _seen(320, (0, 1, 0.8), (0, 2, 0.8), *((k, k + 1, 0.8) for k in range(7)))
    assert min(_sure(network)) > 0.6  # three of the roads meet
    patched = _seen(320, *((k, k + 1, 0.3) for k in range(7)), (7, 8, 0.94))
    assert max(_sure(patched)) < 0.5  # also the one that is clear
    (fainter, *_), (clearer, *_) = (
        _sure(_seen(320, (0, 1, 0.5), (1, 2, 0.5), (2, 3, clear), (3, 4, clear)))
        for clear in (0.7, 0.98)
    )
    assert fainter < 0.6 < clearer


def test_the_clearer_the_colors_the_clearer_roads_have_to_be() -> None:
    """Photos of cats, dishes and machines have vivid colors, photos from the air pale ones."""
    roads = [(k, k + 1, 0.72) for k in range(4)]
    pale, aerial, vivid = (
        _sure(replace(_seen(320, *roads), scores={CHROMA: chroma}))[0] for chroma in (0, 8, 40)
    )
    assert pale == aerial > 0.75
    assert vivid < 0.5
    clear = [(k, k + 1, 0.97) for k in range(4)]
    assert _sure(replace(_seen(320, *clear), scores={CHROMA: 40.0}))[0] > 0.85


def test_gray_has_no_chroma_and_colored_noise_has_little() -> None:
    rng = np.random.default_rng(1)
    noise = rng.integers(0, 256, (900, 900, 3)).astype(np.uint8)
    gray = np.repeat(noise[..., :1], 3, axis=2)
    red = np.full((40, 60, 3), (30, 30, 200), np.uint8)
    assert mean_chroma(gray) == 0.0
    assert mean_chroma(noise) < 25 < 60 < mean_chroma(red)


def test_a_clear_road_is_as_sure_alone_as_in_a_network() -> None:
    (alone,) = _sure(_seen(320, (0, 1, 0.9)))
    assert [alone, alone] == _sure(_seen(320, (0, 1, 0.9), (1, 2, 0.9)))
    assert alone > 0.8


def test_more_evidence_never_makes_a_road_less_sure() -> None:
    for roads in (((0, 1),), ((0, 1), (1, 2))):
        believed = [
            _sure(_seen(320, *((a, b, seen) for a, b in roads)))[0]
            for seen in np.linspace(0.0, 1.0, 40).tolist()
        ]
        assert believed == sorted(believed)
        assert 0 < believed[0] < 0.2
        assert 0.9 < believed[-1] < 1


def test_the_middle_of_wide_roads_is_less_sure() -> None:
    narrow, usual, wide = (
        _sure(_seen(320, (0, 1, 0.95), width=width))[0] for width in (4.0, 12.0, 32.0)
    )
    assert narrow == usual
    assert wide < usual - 0.07


def test_confidence_falls_along_a_road_that_fades() -> None:
    (road,) = calibrated(_seen(320, (0, 1, 0.9), fading=True), doubt_alone=False).roads
    assert road.confidences is not None
    assert (np.diff(road.confidences) <= 1e-12).all()
    assert road.confidences[0] > 0.8
    assert road.confidences[-1] < 0.5
    assert road.confidence == pytest.approx(road.confidences.mean(), abs=1e-4)
