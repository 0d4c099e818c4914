"""Random scenes, placed and checked; and the CPU time of placing them.

python -m benchmarks.placement [COUNT] [FIRST]
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np

from benchmarks.placement.checks import faults
from benchmarks.placement.random_scenes import scene_text
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.ir.encoding import to_json
from roadlang.judging.acceptance import Acceptance
from roadlang.plugins.discovery import load_registry
from roadlang.scenes.sampling import sample_scenes
from roadlang.semantics import check_text
from roadlang.world.index import index_scenario

BATCH = """
road main { draw with segments { pieces: [straight(400m), arc(300m, 90deg), straight(400m)] } }
object trees is tree on main at random { count: 25, side: choice(left, right), offset: 2m..30m }
agent cars is car on main at random { count: 5, drive with car_follow }
"""


def main() -> int:
    """Print the faults of scenes, then the time for each object in a batch of 1,000 scenes."""
    count, first = (int(word) for word in [*sys.argv[1:], "200", "0"][:2])
    registry, things, found, given_up = load_registry(), 0, 0, 0
    for number in range(first, first + count):
        scenario, problems = check_text(scene_text(number), Path("random.rl"), {}, registry)
        assert scenario is not None, problems
        sampled = sample_scenes(scenario, registry, 1, number)
        given_up += not sampled.scenes
        for scene in sampled.scenes:
            record = json.loads(to_json(scene))
            things += len(record["agents"]) + len(record["objects"])
            for fault in faults(record):
                found += 1
                print(f"scene {number}: {fault}")
    print(f"{count} scenes, {things} things: {found} faults, {given_up} scenes without room")
    scenario, _ = check_text(BATCH, Path("batch.rl"), {}, registry)
    assert scenario is not None
    acceptance = Acceptance(index_scenario(scenario, registry))
    for size in (10, 1000):
        start = time.process_time()
        acceptance.judge(CandidateBatch(
            acceptance.scenario, 0, np.arange(size), np.zeros(size, np.int64)
        ))  # fmt: skip
        spent = 1e3 * (time.process_time() - start)
        print(f"{size} scenes of 30 things: {spent / size / 30:.4f} ms for each thing")
    return 0


if __name__ == "__main__":
    sys.exit(main())
