"""Steps of environments for each CPU second: 1,000 scenes with one, five and twenty cars.

    python -m benchmarks.envs [--count 1000] [--steps 300] [--numpy]

An action every 0.1 s, the vehicles at 0.05 s, observations, contacts, rewards and the beginnings
of new episodes included. The driven car steers at random around a constant, so that episodes end
at different times; the others keep their lane and distance. First with numpy alone, then with numba
where it is installed; `--numpy`: with numpy alone.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

import roadlang
from roadlang.envs import SceneVectorEnv
from roadlang.simulation.vehicles import compiled

ROAD = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
  width: 8m, lanes: 2
}
road bent from main {
  perturb with sine { amplitude: -4m..4m, wavelength: 80m..160m, over: [20m, 300m], taper: 30m }
}
agent ego is car on bent at 5m { lane: -1 }
expect in_lane: always (abs(ego.cross_track_error) < 2m)
"""


def scene(cars: int) -> str:
    """A file with that many cars."""
    others = "".join(
        f"agent a{i} is car on bent at {5 + 15 * i}m"
        f" {{ lane: -1, drive with car_follow {{ speed: {10 + i % 3}m/s }} }}\n"
        for i in range(1, cars)
    )
    return ROAD + others


def speed(cars: int, count: int, steps: int) -> tuple[float, float]:
    """Steps for each CPU second, the best of three parts; how many episodes end in a step."""
    env = SceneVectorEnv(roadlang.loads(scene(cars)), count, scenes=min(count, 200))
    env.reset(seed=1)
    random = np.random.default_rng(0)
    wishes = random.uniform(-0.1, 0.1, (20, count, 2)) + np.array([0.0, 0.4])
    actions = list(wishes.astype(np.float32))
    best, ends = 0.0, 0
    for _ in range(3):
        start = time.process_time()
        for number in range(steps // 3):
            _, _, terminated, truncated, _ = env.step(actions[number % 20])
            ends += int((terminated | truncated).sum())
        best = max(best, count * (steps // 3) / (time.process_time() - start))
    return best, ends / (3 * (steps // 3))


def main() -> None:
    """Print the speeds, with numpy and with numba."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--steps", type=int, default=300)
    parser.add_argument("--numpy", action="store_true")
    arguments = parser.parse_args()
    is_installed = compiled.is_installed
    # Without numba first: once its loops are loaded, they are used. Users have no switch for it.
    compiled.is_installed = lambda: False  # type: ignore[assignment]
    report("numpy", arguments.count, arguments.steps)
    compiled.is_installed = is_installed
    if is_installed() and not arguments.numpy:
        compiled.kernel()  # or the first steps would be without it, until loading it pays
        report("numba", arguments.count, arguments.steps)


def report(how: str, count: int, steps: int) -> None:
    """Print a line for each number of cars."""
    for cars in (1, 5, 20):
        found, ends = speed(cars, count, steps)
        print(
            f"{how}, {cars} cars: {found:,.0f} steps for each CPU second, "
            f"{ends:.1f} episodes end in one"
        )


if __name__ == "__main__":
    main()
