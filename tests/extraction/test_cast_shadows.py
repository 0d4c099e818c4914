"""The shadow of a finger is no ink, even where it is as narrow as the light is estimated."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.paper.cast_shadows import without_cast_shadows


def _strokes(shade: float, width: int) -> np.ndarray:
    """A thin line (h, w) across a broad bar of this darkness."""
    ink = np.zeros((200, 300), np.float32)
    ink[60 : 60 + width, 80:200] = shade
    ink[20:180, 140:144] += 0.5
    return np.minimum(ink, np.float32(0.9))


def test_a_line_goes_on_in_the_shadow_of_a_finger() -> None:
    ink = _strokes(0.2, 40)
    lit = without_cast_shadows(ink, ink > 0.1)
    assert np.allclose(lit[20:180, 140:144], 0.5)
    assert not lit[:, :138].any()
    assert not lit[:, 146:].any()


@pytest.mark.parametrize(("shade", "width"), [(0.7, 40), (0.2, 8)], ids=["dark", "narrow"])
def test_a_broad_stroke_stays(shade: float, width: int) -> None:
    """Ink covers a surface as well as a line, and strokes differ in width."""
    ink = _strokes(shade, width)
    assert np.array_equal(without_cast_shadows(ink, ink > 0.1), ink)


def test_blank_paper_has_no_shadow() -> None:
    ink = np.zeros((20, 30), np.float32)
    assert without_cast_shadows(ink, ink > 0.1) is ink
