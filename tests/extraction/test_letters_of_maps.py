"""Letters of maps are found and taken away the same, whether they are few or many."""

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.maps import map_letters
from roadlang_standard.extraction.maps.map_letters import letters_of_map, without_letters


@pytest.mark.parametrize("words", [2, 30])
def test_few_letters_are_looked_at_one_by_one_with_the_same_result(
    words: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(3)
    page = np.full((300, 400, 3), (240, 235, 230), np.uint8)
    cv2.line(page, (0, 150), (400, 170), (180, 200, 250), 9, cv2.LINE_AA)
    for x, y in rng.integers((0, 20), (340, 300), (words, 2)).tolist():
        cv2.putText(page, "Lake", (x, y), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (60, 50, 40), 1, 16)
    letters = letters_of_map(page, 6.0)
    plain = without_letters(page, letters)
    assert letters.any()
    assert not np.array_equal(plain, page)
    for name, value in (("_MANY", 0.0), ("_WORDS", 0)):
        monkeypatch.setattr(map_letters, name, value)
    assert np.array_equal(letters_of_map(page, 6.0), letters)
    assert np.array_equal(without_letters(page, letters), plain)
