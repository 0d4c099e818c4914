"""examples/two_actors.rl: one file under two names, each with its own params."""

from __future__ import annotations

from pathlib import Path

import roadlang

EXAMPLE = Path(__file__).parents[2] / "examples" / "two_actors.rl"


def test_each_included_car_drives_as_its_params_say() -> None:
    (drive,) = roadlang.load(EXAMPLE).sample(1).run("builtin")
    assert drive.satisfied
    slow, fast = (drive.trace.agents[f"{name}.driver"] for name in ("slow", "fast"))
    assert 24 / 3.6 < slow.speed.max() < 26 / 3.6
    assert 44 / 3.6 < fast.speed.max() < 46 / 3.6
    assert abs((fast.y - slow.y).mean() - 8.0) < 0.1
