"""Random traffic scenes in the embedded engine: contacts, red lights, seconds.

    python -m benchmarks.traffic [--scenes 200] [--first 0] [--duration 60]

Ends with 1 if anybody touched anything or crossed a stop line at red.
"""

from __future__ import annotations

import argparse
import sys
import time

from roadlang import testing

from .random_traffic import scene_text


def main() -> int:
    """Drive the scenes and print what went wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--duration", type=float, default=60.0)
    options = parser.parse_args()
    touched = ran = agents = 0
    meters = spent = 0.0
    for seed in range(options.first, options.first + options.scenes):
        scenes = testing.sample(scene_text(seed), 1, seed=seed)
        begin = time.process_time()
        (driven,) = scenes.run("builtin", duration=options.duration)
        spent += time.process_time() - begin
        trace = driven.trace
        cars = trace.agents.values()
        agents += len(trace.agents)
        meters += sum(float(car.route_progress[-1]) for car in cars)
        red = [car.name for car in cars if car.red_light[-1] > 0]
        contacts = [(event["agent"], event["other"]) for event in trace.events]
        touched, ran = touched + bool(contacts), ran + len(red)
        if red or contacts:
            print(f"scene {seed}: contacts {contacts}, red lights {red}")
    print(f"{options.scenes} scenes, {agents} cars, {meters / agents:.0f} m for each")
    print(f"scenes with contacts: {touched}; red lights run: {ran}")
    print(f"{options.scenes * options.duration / spent:.0f} simulated seconds for each CPU second")
    return 1 if touched or ran else 0


if __name__ == "__main__":
    sys.exit(main())
