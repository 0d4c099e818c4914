"""The rectangle of a box in a picture: of all of it that is before the camera, where it reaches
behind it too."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

from roadlang_standard.detected_boxes import NEAREST, BoxCamera

Floats = np.ndarray[Any, np.dtype[np.float64]]
WIDTH, HEIGHT = 640.0, 480.0
CORNERS = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))


def camera(count: int, yaw: float, pitch: float) -> BoxCamera:
    return BoxCamera.of(count, WIDTH, HEIGHT, 1.2, (1.0, 0.5, 1.4), yaw, pitch, 100.0)


def boxes(count: int, seed: int) -> Floats:
    """(1, K, 8, 3): as large as cars, around the camera."""
    random = np.random.default_rng(seed)
    size = random.uniform(1.0, 6.0, (count, 1, 3))
    center = random.uniform((-6.0, -6.0, -1.0), (9.0, 6.0, 3.0), (count, 1, 3))
    angle = random.uniform(-np.pi, np.pi, count)
    turn = np.zeros((count, 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 0, 1], turn[:, 1, 0] = np.sin(angle), -np.sin(angle)
    turn[:, 2, 2] = 1.0
    found: Floats = ((CORNERS * size) @ turn + center)[None]
    return found


def seen_of(camera: BoxCamera, corners: Floats) -> Floats:
    """(4,) the rectangle of many points of all lines between corners (8, 3)."""
    share = np.linspace(0.0, 1.0, 4001)[:, None]
    lines = [a + share * (b - a) for a, b in itertools.combinations(corners, 2)]
    right, down, forward = camera.coordinates(np.concatenate(lines)[None])[0].T
    shown = forward >= NEAREST
    if not shown.any():
        return np.zeros(4)
    focal = 0.5 * WIDTH / np.tan(0.6)
    x = 0.5 * WIDTH + focal * right[shown] / forward[shown]
    y = 0.5 * HEIGHT + focal * down[shown] / forward[shown]
    low = np.clip([x.min(), y.min()], 0.0, [WIDTH, HEIGHT])
    high = np.clip([x.max(), y.max()], 0.0, [WIDTH, HEIGHT])
    return np.concatenate([low, high])


@pytest.mark.parametrize(("yaw", "pitch"), [(0.0, 0.0), (0.7, -0.2), (-2.0, 0.3)])
def test_a_rectangle_is_that_of_all_points_before_the_camera(yaw: float, pitch: float) -> None:
    corners = boxes(60, 3)
    view = camera(1, yaw, pitch)
    found = view.rectangles(corners)[0]
    depth = view.coordinates(corners)[0, ..., 2]
    assert ((depth < NEAREST).any(axis=1) & (depth > 1.0).any(axis=1)).sum() > 10
    for rectangle, box in zip(found, corners[0], strict=True):
        expected = seen_of(view, box)
        if (expected[2:] > expected[:2]).all():
            np.testing.assert_allclose(rectangle, expected, atol=12.0)
            assert np.abs(rectangle - expected).mean() < 4.0
        else:
            assert (rectangle[2:] - rectangle[:2]).min() <= 1.0


def test_what_is_behind_a_camera_is_not_in_its_picture() -> None:
    behind = CORNERS[None, None] - (3.0, 0.0, 0.0)
    left, top, right, bottom = camera(1, 0.0, 0.0).rectangles(behind)[0, 0]
    assert right <= left
    assert bottom <= top


def test_agents_beside_each_other_see_what_each_sees_alone() -> None:
    both = np.concatenate([boxes(9, 1), boxes(9, 2)])
    together = camera(2, 0.3, -0.1).rectangles(both)
    for row in (0, 1):
        alone = camera(1, 0.3, -0.1).rectangles(both[row : row + 1])
        np.testing.assert_array_equal(together[row], alone[0])
