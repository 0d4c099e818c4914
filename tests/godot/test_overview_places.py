"""What an overview looks at: corners of tiles and outlines of things, read from their messages."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from roadlang_godot.rendering.overview_camera import _cells, _outlines


def test_tiles_reach_from_one_corner_to_the_opposite_one() -> None:
    """Of 2 m each, from x = 10 m and z = -20 m on."""
    rows = np.array([(0, 0, 1), (3, -1, 5)], [("x", "<i2"), ("z", "<i2"), ("mask", "u1")])
    head = np.array([2.0, 10.0, -20.0], "<f4").tobytes()
    part: Any = SimpleNamespace(body=head + b"\0\0" + rows.tobytes())
    assert _cells(part).tolist() == [
        [10.0, 0.0, -20.0], [12.0, 0.0, -18.0], [16.0, 0.0, -22.0], [18.0, 0.0, -20.0],
    ]  # fmt: skip


def test_things_are_seen_by_their_corners_east_and_north() -> None:
    """x, height above the ground, z, heading, length, height, width: z points south."""
    rows = np.array(
        [[5.0, 0.3, -7.0, 0.0, 4.0, 1.5, 2.0], [0.0, 0.0, 0.0, np.pi / 2, 6.0, 1.0, 1.0]], "<f4"
    )
    part: Any = SimpleNamespace(content=bytes(24), body=b"names before" + rows.tobytes())
    first, turned = _outlines(part)
    assert first.tolist() == [[7.0, 8.0], [7.0, 6.0], [3.0, 6.0], [3.0, 8.0]]
    np.testing.assert_allclose(
        turned, [[-0.5, 3.0], [0.5, 3.0], [0.5, -3.0], [-0.5, -3.0]], atol=1e-6
    )
