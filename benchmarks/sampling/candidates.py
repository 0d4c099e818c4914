"""Candidates judged per second on one core: a bend by `sine`, phi1, phi2, phi3, a curvature bound.

    python -m benchmarks.sampling.candidates [--save | --quick]

The road is 500 m long and has 501 stations. `judged` counts candidates that went through every
requirement until one rejected them or all held; nothing of a candidate is kept between rounds.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")

import sys
import time
from pathlib import Path

import numpy as np

from benchmarks.baseline import numpy_unit, report, rounds
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.judging.acceptance import Acceptance
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
from roadlang.world.index import index_scenario

ROAD = """
road main { draw with waypoints { points: [
  (0m, 0m), (120m, 10m), (230m, 70m), (350m, 60m), (470m, 70m)
] } }
road bent from main {
  perturb with sine { amplitude: 0m..REACH, wavelength: 60m..200m, phase: 0deg..360deg }
}
let e1 = deviation(bent, main)
let d1 = distance(bent, main)
require phi1: always (e1 < 10m)
require phi2: always (d1 < 10m)
require phi3: always (e1 > 6m implies eventually[20m, 60m] always[0m, 15m] (d1 < 6m and e1 < 6m))
require drivable: always (abs(curvature(bent)) < BOUND)
"""
BATCH = 512
ROUNDS = 60
CASES = (
    ("paper: reach 8 m, radius 10 m", "8m", "0.1/m"),
    ("wide: reach 14 m, radius 14.4 m", "14m", "1 / 14.4m"),
    ("tight: reach 8 m, radius 50 m", "8m", "0.02/m"),
)


def main() -> int:
    """Print the rate of each case, and its cost beside the baseline."""
    registry = load_registry()
    costs = {}
    for title, reach, bound in CASES:
        text = ROAD.replace("REACH", reach).replace("BOUND", bound)
        scenario, found = check_text(text, Path("bench.rl"), {}, registry)
        assert scenario is not None, found
        acceptance = Acceptance(index_scenario(scenario, registry))
        rate, share = measure(acceptance)
        costs[title] = 10_000 / rate / numpy_unit()
        print(f"{title:36} {rate:9,.0f} candidates/s   {share:6.1%} accepted")
    return report("10,000 candidates", costs)


def measure(acceptance: Acceptance) -> tuple[float, float]:
    """Candidates per second and the share accepted."""
    scenes = np.zeros(BATCH, np.int64)
    accepted = 0
    acceptance.judge(CandidateBatch(acceptance.scenario, 0, scenes, np.arange(BATCH)))
    start = time.process_time()
    count = rounds(ROUNDS, 6)
    for round_ in range(count):
        attempts = np.arange(BATCH) + round_ * BATCH
        accepted += int(
            acceptance.judge(
                CandidateBatch(acceptance.scenario, 1, scenes, attempts)
            ).accepted.sum()
        )
    spent = time.process_time() - start
    return count * BATCH / spent, accepted / (count * BATCH)


if __name__ == "__main__":
    sys.exit(main())
