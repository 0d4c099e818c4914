"""Candidates for each accepted scene, and how different the scenes are: guided against rejection.

    python benchmarks/sampling/guided.py [scenes]

`spread` is the mean distance of a scene's draws to those of the nearest other scene, in the unit
cube of the draws. The pilot's candidates count.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from roadlang.evaluate.indexed_scenario import IndexedScenario
from roadlang.plugins.discovery import load_registry
from roadlang.search.diversity import mean_nearest
from roadlang.search.guiding import first_accepted, run_pilot
from roadlang.search.rejection_report import RejectionStats
from roadlang.search.searching import accepted_attempts
from roadlang.search.workers import Worker
from roadlang.semantics import check_text

ROAD = """
road main { draw with waypoints { points: [
  (0m, 0m), (120m, 10m), (230m, 70m), (350m, 60m), (470m, 70m)
] } }
"""
SINE = """
road bent from main {
  perturb with sine { amplitude: 0m..12m, wavelength: 40m..200m, phase: 0deg..360deg }
}
"""
TWO = """
road bent from main {
  perturb with sine { amplitude: 0m..10m, wavelength: 60m..200m, phase: 0deg..360deg }
  perturb with sine { amplitude: 0m..10m, wavelength: 60m..200m, phase: 0deg..360deg }
}
"""
HARMONICS = "road bent from main { perturb with harmonics { modes: 6, amplitude: 0m..30m } }\n"
CASES = {
    "sine, about 1 %": SINE
    + """
require far: eventually (deviation(bent, main) > 10m)
require calm: always (abs(curvature(bent)) < 0.0181/m)
""",
    "sine, about 0.1 %": SINE
    + """
require far: eventually (deviation(bent, main) > 11m)
require calm: always (abs(curvature(bent)) < 0.0170/m)
""",
    "two sines, about 1 %": TWO
    + """
require far: eventually (deviation(bent, main) > 12m)
require calm: always (abs(curvature(bent)) < 0.0196/m)
""",
    "two sines, about 0.1 %": TWO
    + """
require far: eventually (deviation(bent, main) > 14m)
require calm: always (abs(curvature(bent)) < 0.0188/m)
""",
    "harmonics (13 numbers), about 1 %": HARMONICS
    + """
require far: eventually (deviation(bent, main) > 12m)
require calm: always (abs(curvature(bent)) < 0.0105/m)
""",
    "harmonics (13 numbers), about 0.1 %": HARMONICS
    + """
require far: eventually (deviation(bent, main) > 14.5m)
require calm: always (abs(curvature(bent)) < 0.00958/m)
""",
}


def main() -> None:
    """Print a row per case: rejection beside guided sampling."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    registry = load_registry()
    for title, rules in CASES.items():
        text = ROAD + rules + "sample with guided\n"
        scenario, found = check_text(text, Path("bench.rl"), {}, registry)
        assert scenario is not None, found
        worker = Worker(IndexedScenario(scenario, registry), 1, {})
        plain, plain_spread = rejection(worker, number)
        steered, spread, learned = guided(worker, number)
        print(
            f"{title:36} acceptance {1 / plain:7.2%}  rejection {plain:7.1f}  guided {steered:5.1f}"
            f"  fewer {plain / steered:6.1f}x  spread {spread / plain_spread:4.0%}  pilot {learned}"
        )


def rejection(worker: Worker, number: int) -> tuple[float, float]:
    """Attempts per scene and diversity of rejection sampling."""
    accepted, stats = accepted_attempts(worker.judge, 1, range(number), 1_000_000)
    points = []
    for scene, attempt in accepted.items():
        variants = worker.single(scene, attempt, {})
        variants.asked = {}
        worker.judge.measure(variants)
        points.append(worker.coordinates(variants))
    return stats.candidates / len(accepted), mean_nearest(points) or 0.0


def guided(worker: Worker, number: int) -> tuple[float, float, int]:
    """Attempts per scene, diversity and pilot size of guided sampling."""
    from roadlang_standard.sample_guided import Guided

    judge, sampler = worker.judge, Guided()
    pilot = run_pilot(judge, sampler, 1)
    stats = RejectionStats.empty(len(judge.requirements))
    stats.add(pilot.stats)
    points = []
    for scene in range(number):
        found = first_accepted(judge, sampler, pilot, 1, scene, stats)
        assert found is not None
        variants = worker.single(scene, *found)
        variants.asked = {}
        worker.judge.measure(variants)
        points.append(worker.coordinates(variants))
    return stats.candidates / number, mean_nearest(points) or 0.0, pilot.stats.candidates


if __name__ == "__main__":
    np.seterr(all="raise", under="ignore")
    main()
