"""Simulated seconds for each CPU second of the embedded engine: many roads, and one scene.

    python -m benchmarks.drives [--roads 10000] [--numpy]

`--numpy`: without numba, even where it is installed. Making the scenes and checking the file are
not counted; reading the scenes into the engine and making traces are.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Sequence
from typing import Any

from roadlang import testing
from roadlang.api import Scene
from roadlang.drive.controllers import python_controllers
from roadlang.drive.simulators import simulator_of
from roadlang.plugins.discovery import load_registry
from roadlang.simulation.vehicles import compiled

BENT = """
road base {
  draw with segments {
    pieces: [straight(60m), arc(60m, 80deg), straight(60m), arc(50m, -70deg), straight(70m)]
  }
  width: 8m, lanes: 2
}
road bent from base { perturb with harmonics { amplitude: 4m } }
agent ego is car on bent at 5m { lane: -1, drive with stanley { speed: 70km/h } }
"""
LONG = """
road main {
  draw with segments {
    pieces: [
      straight(200m), arc(150m, 80deg), straight(600m), arc(150m, -80deg), straight(800m)
    ]
  }
  width: 8m, lanes: 2
}
"""
ONE = LONG + "agent ego is car on main at 5m { lane: -1, drive with pure_pursuit { speed: 15m/s } }"
TWENTY = LONG + "\n".join(
    f"agent a{i} is car on main at {5 + 25 * i}m"
    f" {{ lane: -1, drive with car_follow {{ speed: {15 + i % 3}m/s }} }}"
    for i in range(20)
)
PLUS = "\n".join(["." * 14 + "#" + "." * 14] * 12 + ["#" * 29] + ["." * 14 + "#" + "." * 14] * 12)
TRAFFIC = """
image plan from \"\"\"
PLUS
\"\"\" { scale: 8m/px }
network town from plan { lanes: 2, speed_limit: 50km/h
  control with signals { green: 12s, yellow: 3s, all_red: 2s }
}
agent cars is choice(car, van, weights: [4, 1]) on town at random {
  count: 20, route_length: 1500m
  drive with traffic { speed_factor: 0.8..1.2, aggression: 0..1 }
}
""".replace("PLUS", PLUS)


def scenes_of(text: str, count: int) -> list[Scene]:
    """The records of `count` scenes."""
    return [scene.record for scene in testing.sample(text, count)]


def speed(scenes: Sequence[Scene], times: int = 3, **options: Any) -> float:
    """Simulated seconds for each CPU second, the best of some times."""
    registry = load_registry()
    controllers = [python_controllers(scene, registry) for scene in scenes]
    _, simulator = simulator_of(scenes[0], registry, "builtin", {"duration": 60.0, **options})
    best = 0.0
    for _ in range(times):
        start = time.process_time()
        driven = sum(float(trace.time[-1]) for trace in simulator.drive_all(scenes, controllers))
        best = max(best, driven / (time.process_time() - start))
    return best


def main() -> None:
    """Print a line for each measurement."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--roads", type=int, default=10_000)
    parser.add_argument("--numpy", action="store_true")
    arguments = parser.parse_args()
    if arguments.numpy:  # as on a machine without numba; users have no switch for it
        compiled.is_installed = lambda: False  # type: ignore[assignment]
    how = "numba" if compiled.is_installed() else "numpy"
    if compiled.is_installed():
        compiled.kernel()
    roads = scenes_of(BENT, arguments.roads)
    for control_step in (0.1, 0.04):
        found = speed(roads, control_step=control_step)
        print(f"{how}: {len(roads)} roads, control every {control_step} s: {found:,.0f}")
    for name, text in (
        ("one car", ONE),
        ("20 cars in a row", TWENTY),
        ("20 cars with `traffic` at a crossing", TRAFFIC),
    ):
        print(f"{how}: one scene, {name}: {speed(scenes_of(text, 1)):,.0f}")


if __name__ == "__main__":
    main()
