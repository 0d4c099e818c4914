"""Candidates for each accepted scene, and how different the scenes are: guided against rejection.

    python -m benchmarks.sampling.guided [scenes]

`spread` is the mean distance of a scene's draws to those of the nearest other scene, in the unit
cube of the draws. The pilot's candidates count.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from roadlang.evaluate.candidates import fixed_candidate
from roadlang.evaluate.evaluation import build
from roadlang.evaluate.kind_instance import KindInstance
from roadlang.ir.read_only import FrozenDict
from roadlang.ir.values import ConstantValue, Options, PassCall
from roadlang.judging.acceptance import Acceptance
from roadlang.plugins.discovery import load_registry
from roadlang.search.accepted import Accepted, candidates_of
from roadlang.search.diversity import mean_nearest
from roadlang.search.guiding import guided_attempts, run_pilot
from roadlang.search.rejection_sampling import accepted_attempts
from roadlang.semantics import check_text
from roadlang.world.index import index_scenario

SEED = 1
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
        acceptance = Acceptance(index_scenario(scenario, registry))
        plain, plain_spread = rejection(acceptance, number)
        steered, spread, learned = guided(acceptance, number)
        print(
            f"{title:36} acceptance {1 / plain:7.2%}  rejection {plain:7.1f}  guided {steered:5.1f}"
            f"  fewer {plain / steered:6.1f}x  spread {spread / plain_spread:4.0%}  pilot {learned}"
        )


def rejection(acceptance: Acceptance, number: int) -> tuple[float, float]:
    """Attempts per scene and diversity of rejection sampling."""
    accepted, stats = accepted_attempts(
        acceptance, _sampler(acceptance, "random"), SEED, range(number)
    )
    return stats.candidates / len(accepted), mean_nearest(coordinates(acceptance, accepted)) or 0.0


def guided(acceptance: Acceptance, number: int) -> tuple[float, float, int]:
    """Attempts per scene, diversity and pilot size of guided sampling."""
    sampler = _sampler(acceptance, "guided")
    accepted, stats = guided_attempts(acceptance, sampler, SEED, range(number))
    assert len(accepted) == number
    pilot = run_pilot(acceptance, sampler, SEED)
    spread = mean_nearest(coordinates(acceptance, accepted)) or 0.0
    return stats.candidates / number, spread, pilot.stats.candidates


def _sampler(acceptance: Acceptance, kind: str) -> KindInstance:
    attempts: Options = FrozenDict({"attempts": ConstantValue(1e6)})
    call = PassCall("sample", f"standard.{kind}", attempts, "sample")
    return build(call, fixed_candidate(acceptance.scenario), single=True)


def coordinates(acceptance: Acceptance, accepted: list[Accepted]) -> list[dict[str, float]]:
    """The draws of each scene in the unit cube, by name."""
    found = []
    for item in accepted:
        candidate = candidates_of([item], acceptance.scenario, SEED)
        acceptance.measure(candidate)
        assert candidate.record is not None
        drawn = candidate.record.named_coordinates().items()
        found.append({name: float(values[0]) for name, values in drawn})
    return found


if __name__ == "__main__":
    np.seterr(all="raise", under="ignore")
    main()
