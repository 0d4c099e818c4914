"""Distinct failures, the first of them and CPU time of searchers on a lane keeper.

    python -m benchmarks.falsification.medium [SEARCHER ...] [--seeds N]

A road of 359 m is displaced by six harmonics, a sine and a cosine of each: 12 draws. About a third
of the roads satisfy the requirements; 1 to 2 % of these fail with random draws. Distinct are
roads whose curvature differs by more than 0.008/m (root mean square), counted greedily.
"""

from __future__ import annotations

import argparse
import statistics
import time

import numpy as np

import roadlang
from roadlang.falsification.descriptors import STATIONS
from roadlang.falsification.outcome import Outcome

LENGTH, AMPLITUDE, FRICTION = 360.0, 5.6, 1.38
HEAD = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
  width: 8m
}
"""
TAIL = f"""
require near: always (abs(deviation(bent, main)) < 10m)
require inside: always (margin(bent, (-5m, -40m), (345m, 80m)) > 0m)
require radius: always (abs(curvature(bent)) < 1 / 14.4m)
agent ego is car on bent at 5m {{ drive with stanley {{ speed: 70km/h }} }}
world {{ friction: {FRICTION} }}
expect in_lane: always (abs(ego.cross_track_error) < 2m)
"""


def scene() -> str:
    """The scene file; harmonic k has a bound of the amplitude by the root of k."""
    waves = "".join(
        f"  perturb with sine {{ amplitude: {-AMPLITUDE / k**0.5:.4f}m..{AMPLITUDE / k**0.5:.4f}m,"
        f" wavelength: {LENGTH / k:.4f}m, phase: {phase}deg, over: [20m, 358m], taper: 30m }}\n"
        for k in range(1, 7)
        for phase in (0, 90)
    )
    return f"{HEAD}road bent from main {{\n{waves}}}\n{TAIL}"


def distinct(failures: list[Outcome]) -> int:
    """How many roads differ from all before them."""
    kept: list[np.ndarray[tuple[int], np.dtype[np.float64]]] = []
    for outcome in failures:
        curvature = np.array(outcome.descriptor[:STATIONS])
        if all(((curvature - other) ** 2).sum() > 1.0 for other in kept):
            kept.append(curvature)
    return len(kept)


def main() -> None:
    """Search with each searcher and seed, and print a line for each."""
    parser = argparse.ArgumentParser()
    parser.add_argument("searchers", nargs="*", default=["cma", "random"])
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--evaluations", type=int, default=2000)
    options = parser.parse_args()
    for searcher in options.searchers:
        counts = []
        for seed in range(1, options.seeds + 1):
            start = time.process_time()
            found = roadlang.loads(scene()).falsify(
                searcher=searcher, evaluations=options.evaluations, seed=seed
            )
            failures = [outcome for outcome in found.outcomes if outcome.is_failure]
            counts.append(distinct(failures))
            first = failures[0].index if failures else None
            print(
                f"{searcher} seed {seed}: {len(failures)} failures, {counts[-1]} distinct, first"
                f" {first}, {len(found.driven)} valid, {time.process_time() - start:.1f} s CPU"
            )
        print(f"{searcher}: median {statistics.median(counts):g} distinct")


if __name__ == "__main__":
    main()
