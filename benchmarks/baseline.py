"""Timings beside those of a saved baseline, in a unit that is about the same on every machine.

The unit is the CPU time of a bare `python -c pass` for whole processes, and of a fixed piece of
numpy for what runs inside one. Ratios to it carry over from machine to machine within a factor of
about 1.5, so a ratio of 2 to the baseline means something.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np

BASELINE = Path(__file__).with_name("baseline.json")
#: More than this many times the baseline is pointed out.
SLOWER = 1.5


def rounds(count: int, quick: int = 1) -> int:
    """How often something is measured; with `--quick` only to see that it works."""
    return quick if "--quick" in sys.argv else count


def process_seconds(command: Sequence[str], runs: int = 7) -> float:
    """Least CPU time, user and system, of a whole process in seconds."""
    return min(_one(command) for _ in range(rounds(runs)))


def _one(command: Sequence[str]) -> float:
    # The first run compiles modules; those that count find them compiled, as users do.
    cached = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        command,
        check=True,
        env=cached,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


@cache
def bare_interpreter() -> float:
    """CPU seconds of a Python that does nothing."""
    return process_seconds([sys.executable, "-c", "pass"], 15)


@cache
def numpy_unit() -> float:
    """CPU seconds of sines and cumulative sums over two million numbers."""
    numbers = np.linspace(0.0, 1.0, 2_000_000)
    times = []
    for _ in range(rounds(15)):
        start = time.process_time()
        np.cumsum(np.sin(numbers) * numbers).sum()
        times.append(time.process_time() - start)
    return min(times)


def report(title: str, units: Mapping[str, float]) -> int:
    """Print `units` beside the baseline, or save them with `--save`; 1 where one is slower."""
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("--save", action="store_true", help="make these numbers the baseline")
    parser.add_argument("--quick", action="store_true", help="few rounds: only to see it work")
    saved = json.loads(BASELINE.read_text(encoding="utf-8")) if BASELINE.exists() else {}
    if parser.parse_args().save:
        saved[title] = {name: round(value, 3) for name, value in units.items()}
        BASELINE.write_text(json.dumps(saved, indent=2) + "\n", encoding="utf-8")
    known = saved.get(title, {})
    slower = 0
    print(f"{title:44s} {'now':>9s} {'baseline':>9s} {'ratio':>6s}")
    for name, value in units.items():
        before = known.get(name)
        ratio = value / before if before else float("nan")
        slower |= ratio > SLOWER
        note = "  SLOWER" if ratio > SLOWER else ""
        print(f"  {name:42s} {value:9.2f} {before or float('nan'):9.2f} {ratio:6.2f}{note}")
    return int(slower)
