"""While a place of a road is dragged, the scene is what the text will compile to."""

from __future__ import annotations

import math

import numpy as np
import pytest

import roadlang
from roadlang.commands import Handle, dragged, handles_of
from roadlang.ir.scene import Scene
from roadlang_godot.editing.dragged_road import with_dragged_road

OPEN = """road main { draw with segments { pieces: [straight(60m), arc(80m, 40deg)] }
  perturb with sine { amplitude: 2m, wavelength: 70m } }
"""
CLOSED = """road main { draw with segments { pieces: [straight(60m), arc(30m, 180deg),
  straight(60m), arc(30m, 180deg)] }, closed: true }
"""
AGENT = "agent ego is car on main at 30m { drive with pure_pursuit { speed: 5m/s } }\n"


def scene_of(text: str) -> Scene:
    return roadlang.loads(text).sample(1, seed=0)[0].record


def handles(text: str, scene: Scene) -> list[Handle]:
    return [handle for handle in handles_of(text, scene) if handle.name == "main"]


@pytest.mark.parametrize("road", [OPEN, CLOSED])
@pytest.mark.parametrize("number", [0, 2, -1])
def test_a_dragged_road_is_the_road_that_is_compiled(road: str, number: int) -> None:
    text = road + AGENT
    before = scene_of(text)
    handle = handles(text, before)[number]
    to = (handle.x + 3.0, handle.y - 2.0)
    shown = with_dragged_road(before, "main", handle.station, (3.0, -2.0), 80.0)
    written = dragged(text, before, handle, to, "nudges")
    assert shown is not None
    assert written is not None
    (seen,), (compiled,) = shown.roads, scene_of(written).roads
    for column, apart in (("x", 0.01), ("y", 0.01), ("stations", 0.05), ("curvature", 0.03)):
        np.testing.assert_allclose(getattr(seen, column), getattr(compiled, column), atol=apart)
    turned = np.subtract(seen.heading, compiled.heading)
    np.testing.assert_allclose(np.cos(turned), 1.0, atol=1e-3)
    assert seen.length == pytest.approx(compiled.length, abs=0.05)
    now = handles(written, shown)[number]
    assert math.dist((now.x, now.y), to) < 0.01
