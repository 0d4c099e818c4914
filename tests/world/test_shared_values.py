"""Values that others use twice are computed once."""

from __future__ import annotations

from collections.abc import Callable

from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]


def test_numbers_that_are_doubled_23_times_are_judged_and_written(sample: Sample) -> None:
    doubled = "".join(f"let m{k} = m{k - 1} + m{k - 1}\n" for k in range(1, 24))
    text = (
        f"{STRAIGHT}let m0 = length(main) + (0m..1m)\n{doubled}"
        "require all: m23 > 1000000km\n"
        "require flat: always (abs(curvature(main)) * m23 < 1)\n"
    )
    (scene,) = sample(text).scenes
    (draw,) = scene.draws.values()
    assert scene.values["m23"] == 2**23 * (200.0 + draw)
