"""Guided sampling knows when it is of use, keeps regions that lie apart, and keeps their spread."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.scenes.sampling import SamplingResult
from roadlang.search.diversity import expected_nearest, mean_nearest
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BENT = """
road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 40m..90m } }
road wide from main { width: 10m..11m }
sample with guided { pilot: 112, attempts: 500 }
"""
NEVER = "sample with guided { fallback: never }\n"


def box_scene(*boxes: tuple[tuple[float, float], ...]) -> str:
    """Parameters x0, x1, ... that must lie in one of the boxes; their draws are their values."""
    params = "".join(f"param x{i} = 0..1\n" for i in range(len(boxes[0])))
    inside = (
        " and ".join(f"x{i} > {low} and x{i} < {high}" for i, (low, high) in enumerate(box))
        for box in boxes
    )
    return params + "require inside: " + " or ".join(f"({box})" for box in inside) + "\n"


def values(result: SamplingResult) -> np.ndarray:
    names = sorted(result.scenes[0].values)
    return np.array([[scene.values[name] for name in names] for scene in result.scenes])


def test_each_of_four_boxes_is_kept(sample: Sample) -> None:
    corners = ((0.1, 0.1), (0.7, 0.15), (0.2, 0.75), (0.8, 0.8))
    boxes = [tuple((low, low + 0.0158) for low in corner) for corner in corners]
    result = sample(box_scene(*boxes) + NEVER, 100)
    inside = [
        sum(all(a < x < b for x, (a, b) in zip(row, box, strict=True)) for row in values(result))
        for box in boxes
    ]
    assert sum(inside) == 100
    assert min(inside) >= 10
    assert result.candidates < 100 * 1000 / 20


def test_thirty_parameters_keep_their_spread(sample: Sample) -> None:
    side = 0.001 ** (1 / 30)
    result = sample(box_scene(tuple((0.1, 0.1 + side) for _ in range(30))) + NEVER, 40)
    assert result.candidates < 40 * 1000 / 20
    assert np.median(values(result).std(axis=0)) > 0.6 * side / np.sqrt(12)


def test_where_even_draws_are_quicker_the_scenes_are_those_of_random(sample: Sample) -> None:
    often = box_scene(((0.2, 0.4), (0.5, 0.6)))
    plain, guided = sample(often, 20), sample(often + "sample with guided\n", 20)
    np.testing.assert_array_equal(values(plain), values(guided))
    assert plain.candidates < guided.candidates <= plain.candidates + 960
    never = sample(often + NEVER, 20)
    assert (values(never) != values(plain)).any()


def test_neither_the_number_of_scenes_nor_their_blocks_change_a_scene(sample: Sample) -> None:
    rare = box_scene(((0.2, 0.22), (0.5, 0.52))) + NEVER
    many = values(sample(rare, 40))
    np.testing.assert_array_equal(values(sample(rare, 3)), many[:3])


def test_what_cannot_hold_is_given_up_after_the_pilot_and_the_attempts(sample: Sample) -> None:
    result = sample(STRAIGHT + BENT + "require thin: always (width(wide) < 9.7m)\n", 3)
    assert result.scenes == ()
    assert result.candidates == 112 + 500


def test_proposals_end_where_they_never_hold(sample: Sample) -> None:
    odd = "require odd: always (abs(width(wide) - 10.5m) < 0.4m and width(wide) < 10m)\n"
    result = sample(STRAIGHT + BENT + odd, 1)
    assert result.scenes == ()
    assert result.candidates == 112 + 500


def test_a_pilot_that_gains_nothing_ends(sample: Sample) -> None:
    flat = "param x = 0..1\nrequire never: x - x * x > 0.3\nsample with guided { attempts: 10 }\n"
    result = sample(flat, 1)
    assert result.scenes == ()
    assert result.candidates < 4_000


@pytest.mark.parametrize("how", ["fallback: sometimes", "fallback: 3"])
def test_other_fallbacks_are_refused(sample: Sample, how: str) -> None:
    with pytest.raises(Exception, match="fallback"):
        sample("param x = 0..1\nsample with guided { " + how + " }\n", 1)


def test_diversity_has_the_value_to_expect_beside_it(sample: Sample) -> None:
    rare = box_scene(((0.4, 0.5), (0.4, 0.5)))
    for tail in ("", NEVER):
        result = sample(rare + tail, 40)
        assert result.diversity is not None
        assert result.expected_diversity == pytest.approx(result.diversity, rel=0.5)
    collapsed = sample(rare + "sample with guided { pilot: 100, fallback: never }\n", 30)
    assert collapsed.diversity is not None
    assert collapsed.expected_diversity is not None
    assert collapsed.diversity < 0.3 * collapsed.expected_diversity


def test_scenes_that_are_much_alike_are_warned_of(tmp_path: Path) -> None:
    rare = box_scene(((0.4, 0.5), (0.4, 0.5)))
    file = tmp_path / "scene.rl"
    codes = []
    for how in ("pilot: 100, fallback: never", "fallback: never"):
        file.write_text(rare + "sample with guided { " + how + " }\n")
        codes.append([found.code for found in roadlang.load(file).sample(30).diagnostics])
    assert codes == [["RL603"], []]


@pytest.mark.parametrize(
    ("points", "expected"),
    [
        ([], None), ([(0.1, 0.2)], None), ([{}, {}], None),
        ([(0.0, 0.0), (0.3, 0.4)], 0.5),
        ([{"a": 0.0, "b": 0.0}, {"b": 0.4, "a": 0.3}], 0.5),
        ([{"a": 0.0, "c": 0.0}, {"b": 0.4, "a": 0.3}], 0.3),
        ([(0.0,), (0.1,), (0.4,)], 0.5 / 3),
    ],
)  # fmt: skip
def test_the_mean_distance_to_the_nearest(points: list[Any], expected: float | None) -> None:
    found = mean_nearest(points)
    assert found == (expected if expected is None else pytest.approx(expected))
    assert (expected_nearest(points, 1.0) is None) == (expected is None)


@pytest.mark.parametrize("factor", [1024.0, 1.0 / 1024.0])
def test_the_unit_of_a_requirement_does_not_matter(sample: Sample, factor: float) -> None:
    """Powers of two: the numbers are the same to the last bit."""
    scene = "param x = 0..0.05\nparam y = 0..1\nrequire low: y < 0.01\nrequire thin: {} < {}\n"
    plain = sample(scene.format("x", 0.01) + NEVER, 10)
    scaled = sample(scene.format(f"{factor} * x", factor * 0.01) + NEVER, 10)
    np.testing.assert_array_equal(values(plain), values(scaled))
