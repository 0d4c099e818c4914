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


@pytest.mark.parametrize("adjuster", [Contrast(3.0), Brightness(1.7), Noise(0.02), Sharpness(5.0)])
def test_what_is_white_or_black_stays_within_a_byte(adjuster: Any) -> None:
    """Nothing wraps round: where it is brighter than white it is white."""
    board = np.kron([[0, 255], [255, 0]], np.ones((20, 20)))[..., None].repeat(3, axis=2)
    changed = adjusted(adjuster, board.astype(np.uint8)).astype(int)
    assert changed[:18, 22:].min() > 100
    assert changed[:18, :18].max() < 100


def test_contrast_is_scaled_about_the_mean() -> None:
    """Of 50 and 150, whose mean is 100, a factor of 1.5 makes 25 and 175."""
    halves = np.full((2, 2, 3), 50, np.uint8)
    halves[1] = 150
    assert adjusted(Contrast(1.5), halves)[:, 0, 0].tolist() == [25, 175]


def test_sharpness_is_by_the_mean_of_nine_pixels() -> None:
    """A dot of 90 on black has 10 in all nine pixels when smoothed; sharpened it has 90 + 80."""
    dot = np.zeros((5, 5, 3), np.uint8)
    dot[2, 2] = 90
    assert adjusted(Sharpness(0.0), dot)[1:4, 1:4].tolist() == [[[10] * 3] * 3] * 3
    assert adjusted(Sharpness(2.0), dot)[2, 2, 0] == 170


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


def test_a_radius_below_a_pixel_blurs_too() -> None:
    """Weights 1, 0.458 and 0.044 at distances 0, 1 and 2: a quarter of the light side of the edge
    reaches the last dark pixel."""
    row = adjusted(Blur(0.8), step())[20, :, 0].astype(float)
    assert row[39:41] == pytest.approx([60 + 30, 180 - 30], abs=1.5)


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


def draws_of(seed: int, width: int, height: int) -> tuple[float, float, float, float, float]:
    """Center x and y, the two half axes as factors of the size, and the angle in degrees."""
    stream = random(seed)
    x, y = stream.uniform(0, width), stream.uniform(0, height)
    first, second = stream.uniform(0.5, 1.5, 2)
    return x, y, float(first), float(second), stream.uniform(0.0, 180.0)


@pytest.mark.parametrize("seed", range(4))
def test_a_shadow_is_an_ellipse_where_and_as_large_as_it_is_drawn(seed: int) -> None:
    gray = np.full((400, 600, 3), 200, np.uint8)
    dark = adjusted(Shadows(1, 30.0, 1.0, 0.0), gray, seed)[..., 0] == 0
    x, y, first, second, angle = draws_of(seed, 600, 400)
    rows, columns = np.mgrid[:400, :600]
    turn = np.radians(angle)
    along = (columns - x) * np.cos(turn) + (rows - y) * np.sin(turn)
    across = (rows - y) * np.cos(turn) - (columns - x) * np.sin(turn)
    level = np.hypot(along / (30 * first), across / (30 * second))
    assert dark[level < 0.93].all()
    assert not dark[level > 1.07].any()


def test_the_soft_edge_of_a_shadow_is_as_wide_as_its_share_of_the_size() -> None:
    """Blurred with a deviation of 0.1 x 80 px: from 16 % to 84 % over twice that."""
    all_draws = (draws_of(seed, 600, 600) for seed in range(99))
    central = (min(d[2:4]) > 1 and abs(d[0] - 300) < 60 and abs(d[1] - 300) < 60 for d in all_draws)
    seed = list(central).index(True)
    x, y = (round(value) for value in draws_of(seed, 600, 600)[:2])
    white = np.full((600, 600, 3), 255, np.uint8)
    light = adjusted(Shadows(1, 80.0, 1.0, 0.1), white, seed)[y, :, 0]
    left = light[:x].astype(float)[::-1] / 255
    width = np.interp(0.84, left, range(len(left))) - np.interp(0.16, left, range(len(left)))
    assert width == pytest.approx(16, rel=0.25)


def test_half_dark_shadows_are_half_as_bright_and_do_not_add_up() -> None:
    gray = np.full((50, 50, 3), 200, np.uint8)
    shaded = adjusted(Shadows(60, 60.0), gray)
    assert shaded[25, 25, 0] == 100
