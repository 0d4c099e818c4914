"""Benchmarks run. How fast they find things is for people to read."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "benchmarks" / "README.md").read_text(encoding="utf-8")
COMPARED = ("benchmarks.startup", "benchmarks.sampling.candidates", "benchmarks.damaged_text")


def test_every_benchmark_of_the_page_is_there() -> None:
    for module in re.findall(r"`python -m (benchmarks[\w.]+)", PAGE):
        place = ROOT / module.replace(".", "/")
        assert place.with_suffix(".py").exists() or (place / "__main__.py").exists(), module
    for path in re.findall(r"`python (benchmarks/\S+\.py)", PAGE):
        assert (ROOT / path).exists(), path


@pytest.mark.slow
@pytest.mark.parametrize("module", COMPARED)
def test_a_benchmark_prints_its_numbers_beside_the_baseline(module: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", module, "--quick"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode in (0, 1), done.stderr
    assert re.search(r" now +baseline +ratio\n.* \d+\.\d\d", done.stdout), done.stdout
