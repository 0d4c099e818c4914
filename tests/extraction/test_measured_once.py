"""What two readings of a map share is measured once."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.maps import map_water
from roadlang_standard.extraction.maps.map_tones import map_tone
from roadlang_standard.extraction.maps.map_water import KnownWater, masks_without_water

_WHITE, _BLACK = np.full(3, 255.0), np.zeros(3)


def _streets() -> np.ndarray:
    mask = np.zeros((200, 200), bool)
    mask[::40] = mask[1::40] = mask[2::40] = True
    return mask


def test_a_color_with_the_same_pixels_is_the_one_that_was_measured() -> None:
    known = [map_tone(_WHITE, ~_streets()), map_tone(_BLACK, _streets())]
    assert map_tone(_BLACK, _streets()).measured_in(known) is known[1]
    other = map_tone(np.full(3, 9.0), _streets())
    assert other.measured_in(known) is other
    moved = map_tone(_BLACK, np.roll(_streets(), 1, axis=0))
    assert moved.measured_in(known) is moved


def test_water_of_a_mask_is_sought_once(monkeypatch: pytest.MonkeyPatch) -> None:
    sought = []
    monkeypatch.setattr(map_water, "_water", lambda mask: sought.append(mask))
    mask, known = _streets(), KnownWater()
    for _ in range(2):
        (_, dry) = masks_without_water([_WHITE, _BLACK], [~mask, mask], known)
        assert dry is mask
    assert len(sought) == 1
    assert sought[0] is mask
