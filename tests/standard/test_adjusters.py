"""What is done to pictures before roads are extracted: how much, in which direction, how random."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang_standard.adjust_blur import Blur
from roadlang_standard.adjust_brightness import Brightness
from roadlang_standard.adjust_contrast import Contrast
from roadlang_standard.adjust_noise import Noise
from roadlang_standard.adjust_shadows import Shadows
from roadlang_standard.adjust_sharpness import Sharpness

NOTHING = [Brightness(1.0), Contrast(1.0), Sharpness(1.0), Blur(0.0), Noise(0.0), Shadows(0, 20.0)]


def random(seed: int = 3) -> np.random.Generator:
    return np.random.default_rng(seed)


def ramp() -> np.ndarray:
    """A picture that gets lighter to the right, from 40 to 200."""
    row = np.linspace(40, 200, 96)
    return np.rint(np.broadcast_to(row[None, :, None], (64, 96, 3))).astype(np.uint8)


def adjusted(adjuster: Any, pixels: np.ndarray | None = None, seed: int = 3) -> np.ndarray:
    result = adjuster.adjust(ramp() if pixels is None else pixels, random(seed))
    assert result.dtype == np.uint8
    return np.asarray(result)


@pytest.mark.parametrize("adjuster", NOTHING, ids=lambda adjuster: adjuster.name)
def test_some_options_change_nothing(adjuster: Any) -> None:
    np.testing.assert_array_equal(adjusted(adjuster), ramp())


def test_brightness_multiplies_and_stays_within_a_byte() -> None:
    np.testing.assert_allclose(adjusted(Brightness(0.5)), ramp() * 0.5, atol=0.5)
    assert adjusted(Brightness(3.0)).max() == 255
    assert (adjusted(Brightness(0.0)) == 0).all()


def test_contrast_keeps_the_mean_and_scales_what_differs_from_it() -> None:
    flat = adjusted(Contrast(0.5)).astype(float)
    assert flat.mean() == pytest.approx(ramp().mean(), abs=0.5)
    assert flat.std() == pytest.approx(ramp().std() / 2, rel=0.02)
    assert len(np.unique(adjusted(Contrast(0.0)))) == 1


def step() -> np.ndarray:
    """Dark to the left, light to the right."""
    pixels = np.full((40, 80, 3), 60, np.uint8)
    pixels[:, 40:] = 180
    return pixels


@pytest.mark.parametrize(("factor", "low", "high"), [(0.0, 60, 180), (3.0, 0, 255)])
def test_sharpness_softens_an_edge_or_overshoots_it(factor: float, low: int, high: int) -> None:
    row = adjusted(Sharpness(factor), step())[20, :, 0].astype(int)
    steepest = np.diff(row).max()
    assert steepest < 120 if factor < 1 else steepest > 120
    assert low <= row.min() <= 60
    assert 180 <= row.max() <= high


@pytest.mark.parametrize("radius", [2.0, 5.0])
def test_blur_spreads_an_edge_by_its_radius(radius: float) -> None:
    """An edge that is blurred is the integral of the filter: 68 % of it within one radius."""
    row = (adjusted(Blur(radius), step())[20, :, 0].astype(float) - 60) / 120
    inside = np.interp(39.5 + radius, range(80), row) - np.interp(39.5 - radius, range(80), row)
    assert inside == pytest.approx(0.683, abs=0.03)


def test_noise_has_the_deviation_of_its_share_of_the_range() -> None:
    gray = np.full((200, 200, 3), 128, np.uint8)
    noisy = adjusted(Noise(0.05), gray).astype(float)
    assert noisy.std() == pytest.approx(0.05 * 255, rel=0.03)
    assert noisy.mean() == pytest.approx(128, abs=0.3)
    assert abs(np.corrcoef(noisy[..., 0].ravel(), noisy[..., 1].ravel())[0, 1]) < 0.02


def test_noise_is_that_of_its_generator() -> None:
    np.testing.assert_array_equal(adjusted(Noise(0.1)), adjusted(Noise(0.1)))
    assert (adjusted(Noise(0.1)) != adjusted(Noise(0.1), seed=4)).any()


@pytest.mark.parametrize("darkness", [0.2, 0.8])
def test_shadows_darken_patches_and_leave_the_rest(darkness: float) -> None:
    gray = np.full((300, 300, 3), 200, np.uint8)
    shaded = adjusted(Shadows(3, 25.0, darkness, 0.0), gray)
    assert set(np.unique(shaded)) == {round(200 * (1 - darkness)), 200}
    area = (shaded[..., 0] < 200).mean() * 300 * 300
    assert 0.2 * np.pi * 25**2 < area < 3 * 2.25 * np.pi * 25**2


def test_soft_shadows_have_shades_between() -> None:
    gray = np.full((300, 300, 3), 200, np.uint8)
    assert len(np.unique(adjusted(Shadows(3, 25.0, 0.5, 0.5), gray))) > 10
