"""Random traffic scenes in the embedded engine: contacts, red lights, who gets stuck, seconds.

    python -m benchmarks.traffic [--scenes 200] [--first 0] [--duration 60]

Ends with 1 if anybody touched anything or crossed a stop line at red. Scenes that have no room
for so many agents are named and counted apart.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from roadlang import testing
from roadlang.ir.scene import Scene, SceneActor
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.session.scene_set import NoSceneError

from .random_traffic import random_scene

STUCK = 30.0
"""Seconds at the end for which who has not moved is stuck, where no signals hold it."""


@dataclass(frozen=True)
class Outcome:
    """What one scene came to."""

    contacts: list[tuple[str, str]]
    red: list[str]
    stuck: list[str]
    agents: int
    meters: float

    @classmethod
    def of(cls, trace: Trace, scene: Scene, rule: str) -> Outcome:
        """Of a drive of a scene, as far as those are concerned who drive with `traffic`."""
        drivers = [one.name for one in scene.agents if _is_traffic(one)]
        cars = [trace.agents[name] for name in drivers]
        return cls(
            [(event["agent"], event["other"]) for event in trace.events],
            [car.name for car in cars if car.red_light[-1] > 0],
            [car.name for car in cars if rule != "signals" and _is_stuck(car)],
            len(cars),
            sum(float(car.route_progress[-1]) for car in cars),
        )

    @property
    def words(self) -> str:
        """What was wrong; empty for nothing."""
        wrong = {"contacts": self.contacts, "red lights": self.red, "stuck": self.stuck}
        return ", ".join(f"{name} {found}" for name, found in wrong.items() if found)


def main() -> int:
    """Drive the scenes and print what went wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--duration", type=float, default=60.0)
    options = parser.parse_args()
    outcomes = []
    spent, refused = 0.0, 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.first, options.first + options.scenes):
            scene = random_scene(seed, Path(folder))
            try:
                scenes = testing.sample(scene.text, 1, seed=seed, folder=folder)
            except NoSceneError as error:
                refused += 1
                print(f"{seed}: {scene.roads}: {str(error).splitlines()[0]}", flush=True)
                continue
            begin = time.process_time()
            (driven,) = scenes.run("builtin", duration=options.duration)
            spent += time.process_time() - begin
            outcomes.append(Outcome.of(driven.trace, scenes[0].record, scene.rule))
            if outcomes[-1].words:
                print(f"{seed}: {scene.roads}, {scene.rule}: {outcomes[-1].words}", flush=True)
    agents = sum(one.agents for one in outcomes)
    meters = sum(one.meters for one in outcomes)
    touched = sum(bool(one.contacts) for one in outcomes)
    ran = sum(len(one.red) for one in outcomes)
    if refused:
        print(f"{refused} scenes without room for all their agents")
    print(f"{len(outcomes)} scenes, {agents} agents, {meters / agents:.0f} m for each")
    print(f"scenes with contacts: {touched}; red lights run: {ran}; ", end="")
    print(f"scenes with somebody stuck: {sum(bool(one.stuck) for one in outcomes)}")
    print(f"{len(outcomes) * options.duration / spent:.0f} simulated seconds for each CPU second")
    return 1 if touched or ran else 0


def _is_traffic(agent: SceneActor) -> bool:
    return bool(agent.drive) and agent.drive[0].kind.split(".")[-1] == "traffic"


def _is_stuck(car: AgentTrace) -> bool:
    """Whether it has stood for long, and is not where its route ends."""
    last = car.time > car.time[-1] - STUCK
    return bool(car.speed[last].max() < 0.1 and car.progress[-1] < 0.99)


if __name__ == "__main__":
    sys.exit(main())
