"""Train a small lane keeper in half a minute of one core, and write it to policy.json.

    python train_policy.py [--generations 30]
    python train_policy.py --failures search   # goes on with policy.json, also where it has failed

A policy is a network with 8 inputs, 6 hidden neurons and 2 outputs. CMA-ES (Hansen 2016) searches
its 68 weights: each of 64 policies is judged by what it earns on the same four scenes, all side by
side in one `SceneVectorEnv`.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import cma
import numpy as np

import roadlang
from roadlang.envs import SceneVectorEnv, Transition

POLICIES, ROADS, HIDDEN = 64, 4, 6
INPUTS = {
    "speed": 0.05, "cross_track_error": 0.5, "heading_error": 2.0, "yaw_rate": 1.0,
    "steering": 2.0, "path_left_10m": 0.2, "path_left_20m": 0.1, "path_left_30m": 0.05,
}  # fmt: skip
"""by what each number of the observation is multiplied"""
ACCELERATION, DECELERATION = 4.0, 8.0
"""m/s^2 that the second action means at 1 and at -1"""
SIZE = (len(INPUTS) + 1) * HIDDEN + (HIDDEN + 1) * 2


def reward(step: Transition) -> np.ndarray:
    """Meters made, less what is too close to the edge of the lane and what is jerky."""
    outside = np.maximum(0.8 - step.margins["in_lane"], 0.0)
    jerky = np.abs(step.action - step.previous_action).sum(axis=1)
    return step.moved - 2.0 * outside - 0.3 * jerky


def actions(weights: np.ndarray, seen: np.ndarray) -> np.ndarray:
    """(N, 2) of N policies, `weights` (N, 68) and inputs (N, 8)."""
    count, inputs = seen.shape
    first = weights[:, : (inputs + 1) * HIDDEN].reshape(count, inputs + 1, HIDDEN)
    second = weights[:, (inputs + 1) * HIDDEN :].reshape(count, HIDDEN + 1, 2)
    hidden = np.tanh(np.einsum("ni,nij->nj", seen, first[:, :-1]) + first[:, -1])
    return np.tanh(np.einsum("ni,nij->nj", hidden, second[:, :-1]) + second[:, -1])


def earned(env: SceneVectorEnv, weights: np.ndarray, seeds: list[int]) -> np.ndarray:
    """(P,) the mean reward of P policies over the scenes of these seeds, until each drive ends."""
    each = np.repeat(weights, len(seeds), axis=0)
    columns = [env.names.index(name) for name in INPUTS]
    scale = np.array(list(INPUTS.values()))
    seen, _ = env.reset(seed=seeds * len(weights))
    total, alive = np.zeros(len(each)), np.ones(len(each), dtype=bool)
    while alive.any():
        wanted = actions(each, seen[:, columns] * scale)
        seen, rewards, terminated, truncated, _ = env.step(wanted)
        total += rewards * alive
        alive &= ~(terminated | truncated)
    return total.reshape(len(weights), -1).mean(axis=1)


def scenes(failures: str | None) -> list[roadlang.Scene]:
    """Random ones; of those that `roadlang falsify` found, if there are any, as many again."""
    drawn = list(roadlang.load("policy_keeper.rl").sample(100))
    if failures is None:
        return drawn
    files = sorted(Path(failures, "failures").glob("????.json"))
    if not files:
        raise SystemExit(f"{failures} has no failures to learn from: search with another --seed")
    failing = [roadlang.Scene.from_json(file.read_text(encoding="utf-8")) for file in files]
    return drawn + [failing[i % len(failing)] for i in range(len(drawn))]


def main() -> None:
    """Search, print a line for every tenth generation, and write the best."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--generations", type=int, default=30)
    parser.add_argument("--failures", metavar="DIR", help="what `roadlang falsify` wrote")
    arguments = parser.parse_args()
    roads = scenes(arguments.failures)
    env = SceneVectorEnv(
        roads,
        POLICIES * ROADS,
        duration=30.0,
        acceleration=ACCELERATION,
        deceleration=DECELERATION,
        reward=reward,
        agents=0,
    )
    start, spread = np.zeros(SIZE), 0.5
    if arguments.failures is not None:
        start = np.array(json.loads(Path("policy.json").read_text(encoding="utf-8"))["weights"])
        spread = 0.1
    settings = {"popsize": POLICIES, "seed": 1, "verbose": -9}
    search = cma.CMAEvolutionStrategy(start, spread, settings)
    for generation in range(arguments.generations):
        candidates = np.array(search.ask())
        found = earned(env, candidates, [ROADS * generation + i for i in range(ROADS)])
        search.tell(list(candidates), list(-found))
        if generation % 10 == 0 or generation == arguments.generations - 1:
            print(f"generation {generation}: mean {found.mean():.1f}, best {found.max():.1f}")
    meaning = {
        "steering": roads[0].agents["ego"].options["max_steering"],  # all that the car can
        "acceleration": ACCELERATION,
        "deceleration": DECELERATION,
    }
    weights = search.mean.tolist()
    policy = {"inputs": INPUTS, "hidden": HIDDEN, "actions": meaning, "weights": weights}
    Path("policy.json").write_text(json.dumps(policy), encoding="utf-8")


if __name__ == "__main__":
    main()
