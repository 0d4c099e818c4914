"""Searches with several searchers and seeds, a line for each, and the medians."""

from __future__ import annotations

import argparse
import statistics
import time
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

import roadlang
from roadlang.api import ROAD_PLACES
from roadlang.falsification.outcome import Outcome


def compare(text: str, apart: Sequence[str] = ()) -> None:
    """Search the scene file with the searchers of the command line. `apart`: draws of which other
    values make failures distinct."""
    parser = argparse.ArgumentParser()
    parser.add_argument("searchers", nargs="*", default=["cma", "random"])
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--first", type=int, default=1, help="the first of the seeds")
    parser.add_argument("--evaluations", type=int, default=2000)
    options = parser.parse_args()
    for searcher in options.searchers or ["cma", "random"]:
        counts, firsts = [], []
        for seed in range(options.first, options.first + options.seeds):
            start = time.process_time()
            found = roadlang.loads(text).falsify(
                searcher=searcher, evaluations=options.evaluations, seed=seed
            )
            failures = [outcome for outcome in found.outcomes if outcome.is_failure]
            counts.append(distinct(failures, apart))
            firsts.append(failures[0].index if failures else options.evaluations)
            print(
                f"{searcher} seed {seed}: {len(failures)} failures, {counts[-1]} distinct, first"
                f" {firsts[-1] if failures else None}, {len(found.driven)} valid,"
                f" {time.process_time() - start:.1f} s CPU",
                flush=True,
            )
        median, first = statistics.median(counts), statistics.median(firsts)
        print(f"{searcher}: median {median:g} distinct, first {first:g}", flush=True)


def distinct(failures: Sequence[Outcome], apart: Sequence[str] = ()) -> int:
    """How many failures differ from all before them: in a draw of `apart`, or in the curvature of
    their roads by more than 0.008/m (root mean square)."""
    known: Mapping[Any, list[Any]] = defaultdict(list)
    for outcome in failures:
        curvature = np.array(outcome.descriptor[:ROAD_PLACES])
        like = known[tuple(outcome.draws[name] for name in apart)]
        if all(((curvature - other) ** 2).sum() > 1.0 for other in like):
            like.append(curvature)
    return sum(map(len, known.values()))
