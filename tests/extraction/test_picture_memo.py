"""A picture is measured once in an extraction, and anew in the next one."""

from __future__ import annotations

import gc

import numpy as np

from roadlang_standard.extraction.colors.picture_memo import OncePerPicture, measuring_once


def _counted() -> tuple[list[int], OncePerPicture[int]]:
    calls: list[int] = []

    def brightest(image: np.ndarray, more: int = 0) -> int:
        calls.append(1)
        return int(image.max()) + more

    return calls, OncePerPicture(brightest)


def test_it_is_measured_once_while_that_is_remembered() -> None:
    calls, brightest = _counted()
    image = np.full((2, 2, 3), 7, np.uint8)
    with measuring_once():
        assert [brightest(image), brightest(image), brightest(image, 2)] == [7, 7, 9]
    assert len(calls) == 2


def test_a_picture_that_was_painted_on_is_measured_anew() -> None:
    _, brightest = _counted()
    image = np.full((2, 2, 3), 7, np.uint8)
    with measuring_once():
        assert brightest(image) == 7
    image[0, 0] = 200
    assert brightest(image) == 200
    with measuring_once():
        assert brightest(image) == 200


def test_a_picture_in_the_place_of_one_that_is_gone_is_another() -> None:
    calls, brightest = _counted()
    with measuring_once():
        for value in range(50):
            assert brightest(np.full((4, 4, 3), value, np.uint8)) == value
            gc.collect(0)
    assert len(calls) == 50
