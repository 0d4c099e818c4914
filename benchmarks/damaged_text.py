"""CPU time to parse and explain damaged scene files, in units of a fixed piece of numpy.

python -m benchmarks.damaged_text [--save | --quick]
"""

from __future__ import annotations

import random
import sys
import time
from pathlib import Path

import numpy as np

from benchmarks.baseline import numpy_unit, report, rounds
from roadlang.diagnostics import Source
from roadlang.diagnostics.render import render_all
from roadlang.syntax import parse
from tests.syntax.mutations import mutated

TESTS = Path(__file__).parents[1] / "tests" / "syntax"


def main() -> int:
    """Median and worst of two thousand damaged files."""
    samples = [path.read_text(encoding="utf-8") for path in sorted(TESTS.glob("samples/*.rl"))]
    chance = random.Random(1)
    times = []
    for _ in range(rounds(2000, 200)):
        text = mutated(chance.choice(samples), chance)
        start = time.process_time()
        _, found = parse(Source("damaged.rl", text))
        render_all(found)
        times.append(time.process_time() - start)
    unit = numpy_unit()
    print(f"unit: {1000 * unit:.1f} ms of CPU time")
    return report(
        "damaged text",
        {"median": float(np.median(times)) / unit, "worst": max(times) / unit},
    )


if __name__ == "__main__":
    sys.exit(main())
