"""What a search costs on workers: CPU of an evaluation, bytes that travel, CPU of the main process.

python -m benchmarks.workers [--dask]
"""

from __future__ import annotations

import argparse
import dataclasses
import pickle
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

import roadlang
from benchmarks.falsification.bent_road import lane_keeper
from benchmarks.falsification.medium import FRICTION
from roadlang.falsification.axes import axes_of
from roadlang.falsification.distinct import DistinctFailures
from roadlang.falsification.evaluator import Evaluator, Proposal, Task
from roadlang.falsification.grading import Grading
from roadlang.falsification.islands import Islands
from roadlang.falsification.journal import SearchJournal
from roadlang.falsification.outcome import Outcome
from roadlang.falsification.settings import plan_of
from roadlang.world.index import index_scenario

PARTS = (1, 2, 8, 32, 128)
EVALUATIONS, TASKS, SEED = 256, 400, 1


def main() -> None:
    """Print the table of the page on many workers."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--dask", action="store_true", help="also measure a Dask cluster")
    options = parser.parse_args()
    evaluator = _evaluator()
    outcomes = _cost_of_evaluations(evaluator)
    _bytes(evaluator, outcomes)
    for searcher in ("cma", "halton", "random"):
        _cost_of_the_search(evaluator, searcher)
    with ProcessPoolExecutor(1) as pool:
        _overhead("concurrent.futures", pool)
    if options.dask:
        from distributed import Client, LocalCluster

        with (
            LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster,
            Client(cluster) as client,
        ):
            _overhead("Dask", client.get_executor(pure=False))


def _evaluator() -> Evaluator:
    loaded = roadlang.loads(lane_keeper(FRICTION))
    indexed = index_scenario(loaded.scenario, loaded.registry)
    axes = tuple(axis.name for axis in axes_of(indexed, SEED))
    return Evaluator(Task(loaded.scenario, loaded.registry, SEED, axes, ("in_lane",)))


def _proposals(evaluator: Evaluator, first: int, count: int) -> list[Proposal]:
    points = np.random.Generator(np.random.PCG64(first)).random((count, len(evaluator.task.axes)))
    return [Proposal(first + i, tuple(point)) for i, point in enumerate(points.tolist())]


def _cost_of_evaluations(evaluator: Evaluator) -> list[Outcome]:
    evaluator.evaluate(_proposals(evaluator, 0, 64))  # caches
    found: list[Outcome] = []
    for size in PARTS:
        parts = [_proposals(evaluator, start, size) for start in range(0, EVALUATIONS, size)]
        start = time.process_time()
        for part in parts:
            found += evaluator.evaluate(part)
        spent = (time.process_time() - start) / EVALUATIONS
        print(f"evaluation, {size} together: {1000 * spent:.2f} ms of CPU")
    return found


def _bytes(evaluator: Evaluator, outcomes: Sequence[Outcome]) -> None:
    print(f"state, once for each worker: {len(pickle.dumps(evaluator)) / 1000:.1f} kB")
    proposals = _proposals(evaluator, 0, 100)
    print(f"proposal: {len(pickle.dumps(proposals)) / 100:.0f} bytes")
    some = list(outcomes[:1000])
    print(f"outcome: {len(pickle.dumps(some)) / len(some):.0f} bytes")


def _cost_of_the_search(evaluator: Evaluator, searcher: str) -> None:
    """CPU of what the main process does of each outcome: propose, grade, tell, write down."""
    indexed = evaluator.scenario
    plan, expects = plan_of(indexed, SEED, searcher, {"evaluations": 2000, "batch": 500})
    known = evaluator.evaluate(_proposals(evaluator, 0, 40))
    # What screens candidates runs on the workers.
    islands = Islands(plan, axes_of(indexed, SEED), lambda points: np.zeros(len(points)))
    grading = Grading(expects)
    distinct, count = DistinctFailures(), 0
    with TemporaryDirectory() as folder:
        journal = SearchJournal(Path(folder) / "journal.jsonl", "key", resume=False)
        start = time.process_time()
        while count < 2000:
            proposals = islands.ask(count, 2000 - count)
            found = [_as(known[i % len(known)], proposal) for i, proposal in enumerate(proposals)]
            found = pickle.loads(pickle.dumps(found))
            journal.append(found)
            islands.tell(found, grading.values(found))
            for outcome in found:
                if outcome.is_failure:
                    distinct.add(outcome)
            count += len(found)
        spent = (time.process_time() - start) / count
    print(f"main process with {searcher}: {1000 * spent:.3f} ms of CPU for each evaluation")


def _as(outcome: Outcome, proposal: Proposal) -> Outcome:
    return dataclasses.replace(outcome, index=proposal.index, point=proposal.point)


def _nothing(size: int) -> bytes:
    return bytes(size)


def _overhead(name: str, executor: Any) -> None:
    """CPU and wall time of a job that does nothing and gives 8 outcomes' worth of bytes."""
    executor.submit(_nothing, 1).result()
    wall, cpu = time.perf_counter(), time.process_time()
    for future in [executor.submit(_nothing, 12_000) for _ in range(TASKS)]:
        future.result()
    cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
    print(
        f"{name}: {1000 * cpu / TASKS:.2f} ms of CPU here for each job, {TASKS / wall:.0f} jobs/s"
    )


if __name__ == "__main__":
    main()
