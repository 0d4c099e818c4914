"""Every option of an extractor reaches what reads the picture, in pixels of it."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from roadlang.api import OptionError, Picture
from roadlang_standard.extract_aerial import Aerial
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extract_contour import Contour
from roadlang_standard.extraction.drawings.thresholding import ContourSteps
from roadlang_standard.extraction.networks.found_network import FoundNetwork
from roadlang_standard.extraction.photos.aerial import Cutoffs, Request

NOISE = np.random.default_rng(1).integers(0, 255, (90, 120, 3), dtype=np.uint8)
PHOTO = Picture(NOISE, 0.5)
"""Half a meter a pixel."""
EMPTY = FoundNetwork(np.zeros((0, 2)), (), np.zeros((90, 120), bool))
BOX = ((1.0, 2.0), (3.0, 4.0))


@pytest.fixture
def requests(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What readers of pictures are asked for."""
    seen: list[Any] = []

    def read(pixels: Any, request: Any, *_: Any) -> FoundNetwork:
        seen.append(request)
        return EMPTY

    monkeypatch.setattr("roadlang_standard.extraction.photos.cache.remembered", read)
    monkeypatch.setattr("roadlang_standard.extraction.drawings.thresholding.roads_by_contour", read)
    return seen


@pytest.mark.parametrize(
    ("options", "request_"),
    [
        ({}, {}),
        ({"threshold": 0.3}, {"threshold": 0.3}),
        ({"width": 7.0}, {"width": 14.0}),
        ({"through": ((5.0, 6.0),)}, {"through": ((5.0, 6.0),)}),
        ({"leave_out": (BOX,)}, {"leave_out": (BOX,)}),
        (
            {"through": ((5.0, 6.0),), "only_through": True},
            {"through": ((5.0, 6.0),), "only_through": True},
        ),
        ({"resolution": "unknown"}, {"meters_per_pixel": None}),
        ({"resolution": 0.2}, {"meters_per_pixel": 0.2}),
    ],
    ids=str,
)
@pytest.mark.parametrize("kind", [Aerial, Auto])
def test_options_for_photos(
    kind: Any, options: dict[str, Any], request_: dict[str, Any], requests: list[Any]
) -> None:
    kind(**options).extract(PHOTO)
    assert requests == [Request(**{"meters_per_pixel": 0.5, **request_})]


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({"through": ((5.0, 6.0), (1e9, 6.0))}, "(1e+09px, 6px), but the picture has 120 x 90 px"),
        ({"leave_out": (((200.0, 0.0), (300.0, 50.0)),)}, "but the picture has 120 x 90 px"),
        ({"leave_out": (((-9.0, -9.0), (-3.0, -3.0)),)}, "but the picture has 120 x 90 px"),
        ({"width": 61.0}, "`width` is 122 px at 0.5 m/px, but the picture has 120 x 90 px"),
        ({"only_through": True}, "`only_through` needs `through`"),
    ],
    ids=str,
)
@pytest.mark.parametrize("kind", [Aerial, Auto])
def test_hints_lie_in_the_picture(kind: Any, options: dict[str, Any], reason: str) -> None:
    """The border itself, which a click may round to, is in it."""
    with pytest.raises(OptionError, match=re.escape(reason)):
        kind(**options).extract(PHOTO)


def test_a_click_on_the_border_is_in_the_picture(requests: list[Any]) -> None:
    Auto(through=((-0.5, 0.0), (120.0, 90.0)), width=60.0).extract(PHOTO)
    assert len(requests) == 1


def test_boxes_that_a_drawing_does_not_use_are_told() -> None:
    drawing = np.full((90, 120, 3), 255, np.uint8)
    drawing[40:50] = 40
    found = Auto(leave_out=(BOX,)).extract(Picture(drawing, 0.5))
    assert found.remarks[1].startswith("`leave_out` is for photos and was ignored")


def test_the_shortest_dead_end_of_photos_is_in_meters(requests: list[Any]) -> None:
    Aerial(min_length=10.0).extract(PHOTO)
    assert requests[0].min_length == 20.0


@pytest.mark.parametrize(
    ("options", "steps"),
    [
        ({}, {}),
        ({"blur": 1.5}, {"blur": 1.5}),
        ({"threshold": 0.3}, {"threshold": 0.3}),
        ({"road": "light"}, {"road": "light"}),
        ({"edges": False}, {"between": False}),
        ({"spline": False}, {"spline": False}),
        ({"width": 7.0}, {"width": 14.0}),
        ({"min_length": 10.0}, {"min_length": 20.0}),
    ],
    ids=str,
)
def test_options_for_drawings(
    options: dict[str, Any], steps: dict[str, Any], requests: list[Any]
) -> None:
    Contour(**options).extract(PHOTO)
    assert requests == [ContourSteps(**steps)]


def test_a_drawing_read_by_itself_takes_threshold_and_width(requests: list[Any]) -> None:
    drawing = np.full((90, 120, 3), 255, np.uint8)
    drawing[40:50] = 40
    Auto(threshold=0.3, width=7.0).extract(Picture(drawing, 0.5))
    assert requests == [ContourSteps(threshold=0.3, width=14.0)]


def test_a_way_through_a_drawing_is_read_as_in_a_photo(requests: list[Any]) -> None:
    drawing = np.full((90, 120, 3), 255, np.uint8)
    drawing[40:50] = 40
    Auto(through=((5.0, 45.0), (100.0, 45.0))).extract(Picture(drawing, 0.5))
    assert isinstance(requests[0], Request)


def test_a_request_in_another_size_of_the_picture() -> None:
    """Centers of pixels: 10 becomes 20.5 in a picture twice as large."""
    request = Request(0.3, 7.0, ((10.0, 20.0),), (BOX,), True, 12.0, 0.5).at(2.0)
    assert request == Request(
        0.3, 14.0, ((20.5, 40.5),), (((2.5, 4.5), (6.5, 8.5)),), True, 24.0, 0.5
    )
    assert Request().at(2.0) == Request()


def test_cutoffs_are_relaxed_by_a_share_and_bridges_may_cost_more() -> None:
    half = Cutoffs(strong=0.8, weak=0.6, floor=0.5).relaxed(0.5)
    assert (half.strong, half.weak, half.floor) == (0.4, 0.3, 0.25)
    assert Cutoffs().relaxed(0.5) != Cutoffs()
