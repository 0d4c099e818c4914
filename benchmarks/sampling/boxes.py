"""Guided sampling of boxes in the unit cube, whose exact answer is known.

    python -m benchmarks.sampling.boxes [scenes [seeds]]

`fewer`: rejection's expected candidates over guided's, its pilot counted, with `fallback: never`.
`spread`: the mean distance to the nearest other scene, over that of as many even draws in the same
boxes; `deviation`: the median standard deviation of a coordinate, likewise. `time`: the CPU time of
`sample with guided`, as it is by default, over that of `sample with random`.
"""

from __future__ import annotations

import statistics
import sys
import time
from pathlib import Path

import numpy as np

from benchmarks.sampling.guided import coordinates
from roadlang.geometry import Floats
from roadlang.judging.acceptance import Acceptance
from roadlang.plugins.discovery import load_registry
from roadlang.search.diversity import mean_nearest
from roadlang.search.guiding import guided_attempts
from roadlang.search.rejection_sampling import accepted_attempts
from roadlang.search.samplers import sampler_of
from roadlang.semantics import check_text
from roadlang.world.index import index_scenario

CORNERS = ((0.10, 0.10), (0.70, 0.15), (0.20, 0.75), (0.80, 0.80))
NEVER = "sample with guided { fallback: never, attempts: 1000000 }\n"


def boxes(dimensions: int, share: float, count: int, seed: int) -> Floats:
    """(count, d, 2): lower and upper ends; together they hold `share` of the cube."""
    side = (share / count) ** (1 / dimensions)
    rng = np.random.default_rng(seed)
    if count == 1:
        low = rng.uniform(0, 1 - side, (1, dimensions))
    else:
        low = np.array([CORNERS[k] for k in range(count)])[:, :dimensions]
    return np.stack([low, low + side], axis=2)


def scene(ends: Floats) -> str:
    """A file whose only requirement is that the parameters lie in one of the boxes."""
    params = "".join(f"param x{i} = 0..1\n" for i in range(ends.shape[1]))
    inside = (
        " and ".join(f"x{i} > {low:.9f} and x{i} < {high:.9f}" for i, (low, high) in enumerate(box))
        for box in ends
    )
    return params + "require inside: " + " or ".join(f"({box})" for box in inside) + "\n"


def acceptance_of(text: str) -> Acceptance:
    """The requirements of a file."""
    registry = load_registry()
    scenario, found = check_text(text, Path("boxes.rl"), {}, registry)
    assert scenario is not None, found
    return Acceptance(index_scenario(scenario, registry))


def points_of(acceptance: Acceptance, number: int, seed: int) -> tuple[Floats, float]:
    """(number, d) draws of guided sampling, and candidates per scene."""
    sampler = sampler_of(acceptance.scenario)
    accepted, stats = guided_attempts(acceptance, sampler, seed, range(number))
    found = coordinates(acceptance, accepted)
    return np.array([list(row.values()) for row in found]), stats.candidates / number


def seconds(text: str, number: int, seed: int) -> float:
    """CPU time of the search for `number` scenes in blocks, without reading the file."""
    acceptance = acceptance_of(text)
    sampler = sampler_of(acceptance.scenario)
    search = guided_attempts if "guided" in text else accepted_attempts
    start = time.process_time()
    for first in range(0, number, 16):
        search(acceptance, sampler, seed, range(first, min(first + 16, number)))
    return time.process_time() - start


def main() -> None:
    """Print a row per case."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    seeds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    for dimensions, share, count in (
        *((d, p, 1) for p in (0.01, 0.001) for d in (2, 6, 12, 30)),
        (2, 0.01, 4),
        (2, 0.001, 4),
    ):
        rows = [row(dimensions, share, count, number, seed) for seed in range(1, seeds + 1)]
        texts = [
            " ".join(f"{value:6.2f}" for value in column) for column in zip(*rows, strict=True)
        ]
        names = ("fewer", "spread", "deviation", "least box %", "time")
        print(f"d={dimensions:2} {share:6.2%} boxes {count}  " + "  ".join(
            f"{name} {text}" for name, text in zip(names, texts, strict=True)
        ))  # fmt: skip


def row(
    dimensions: int, share: float, count: int, number: int, seed: int
) -> tuple[float, float, float, float, float]:
    """What a case comes to."""
    ends = boxes(dimensions, share, count, seed)
    points, cost = points_of(acceptance_of(scene(ends) + NEVER), number, seed)
    rng = np.random.default_rng(99)
    even = []
    for _ in range(10):
        chosen = ends[rng.integers(count, size=number)]
        even.append(rng.uniform(chosen[:, :, 0], chosen[:, :, 1]))
    nearest = statistics.mean(mean_nearest(sample.tolist()) or 0.0 for sample in even)
    deviation = float(np.median(np.mean([sample.std(axis=0) for sample in even], axis=0)))
    inside = ((points[:, None] > ends[..., 0]) & (points[:, None] < ends[..., 1])).all(axis=2)
    slow = "sample with random { attempts: 1000000 }\n"
    times = [seconds(scene(ends) + "sample with guided\n", number, seed)]
    times.append(seconds(scene(ends) + slow, number, seed))
    return (
        1 / share / cost,
        (mean_nearest(points.tolist()) or 0.0) / nearest,
        float(np.median(points.std(axis=0))) / deviation,
        100 * float(inside.mean(axis=0).min()),
        times[0] / times[1],
    )


if __name__ == "__main__":
    main()
