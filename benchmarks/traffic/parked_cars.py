"""Traffic in typed towns with cars parked badly in the lanes: contacts with them, who gets stuck.

    python -m benchmarks.traffic.parked_cars [--scenes 24] [--first 0] [--duration 90] [--stay]

`--stay`: traffic does not go around (`go_around: false`). Ends with 1 if anybody touched anything
or crossed a stop line at red.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path
from random import Random

from roadlang import testing
from roadlang.session.scene_set import NoSceneError

from .__main__ import Outcome
from .plans import town

CONTROLS = ("", "control with signals { green: 12s }", "control with yield", "control with stop")
SCALE = 8
"""Meters of a square of the maps."""
KINDS = ("car", "car", "choice(car, van, truck, bus, weights: [5, 2, 1, 1])")


def parked_scene(seed: int, goes_around: bool) -> str:
    """The same roads, cars and parked cars for one seed."""
    draw = Random(f"parked {seed}")
    options = "speed_factor: 0.8..1.1, aggression: 0..1"
    options += "" if goes_around else ", go_around: false"
    side = "world { traffic: left }\n" if draw.random() < 0.25 else ""
    plan = town(draw)
    x, y = _near_a_corner(draw, plan)
    return (
        f'image plan from """\n{plan}\n""" {{ scale: {SCALE}m/px }}\n'
        f"network town from plan {{ lanes: 2, speed_limit: {draw.choice((30, 50))}km/h\n"
        f"{draw.choice(CONTROLS)} }}\n{side}"
        f"agent cars is {draw.choice(KINDS)} on town at random {{ count: 10, "
        f"route_length: 1500m, drive with traffic {{ {options} }} }}\n"
        "object parked is choice(parked_car, parked_van, weights: [3, 1]) on town at random "
        "{ count: 3, lane: choice(-1, 1), offset: -1.6m..1.6m, heading: -20deg..20deg }\n"
        f"object corner is parked_car at ({x:.1f}m, {y:.1f}m) "
        f"{{ heading: {draw.uniform(0.0, 360.0):.0f}deg }}\n"
    )


def _near_a_corner(draw: Random, plan: str) -> tuple[float, float]:
    """A place within 8 m of where two streets meet, or one bends."""
    rows = plan.split("\n")
    columns = [x for x in range(len(rows[0])) if all(row[x] == "#" for row in rows)]
    row = draw.choice([y for y, row in enumerate(rows) if set(row) == {"#"}])
    x, y = draw.choice(columns) + 0.5, len(rows) - row - 0.5
    return SCALE * x + draw.uniform(-8.0, 8.0), SCALE * y + draw.uniform(-8.0, 8.0)


def main() -> int:
    """Drive the scenes and print what went wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=24)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--duration", type=float, default=90.0)
    parser.add_argument("--stay", action="store_true")
    given = parser.parse_args()
    outcomes = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.first, given.first + given.scenes):
            outcome = _outcome(seed, not given.stay, given.duration, Path(folder))
            if outcome is None:
                print(f"{seed}: no room", flush=True)
                continue
            outcomes.append(outcome)
            if outcome.words:
                print(f"{seed}: {outcome.words}", flush=True)
    meters = sum(one.meters for one in outcomes) / sum(one.agents for one in outcomes)
    touched = sum(bool(one.contacts) for one in outcomes)
    ran = sum(len(one.red) for one in outcomes)
    stuck = sum(len(one.stuck) for one in outcomes)
    print(f"{len(outcomes)} scenes, {meters:.0f} m for each agent")
    print(f"scenes with contacts: {touched}; red lights run: {ran}; agents stuck: {stuck}")
    return 1 if touched or ran else 0


def _outcome(seed: int, goes_around: bool, duration: float, folder: Path) -> Outcome | None:
    text = parked_scene(seed, goes_around)
    try:
        scenes = testing.sample(text, 1, seed=seed, folder=folder)
    except NoSceneError:
        return None
    (driven,) = scenes.run("builtin", duration=duration)
    rule = "signals" if "signals" in text else ""
    return Outcome.of(driven.trace, scenes[0].record, rule)


if __name__ == "__main__":
    sys.exit(main())
