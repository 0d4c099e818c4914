"""numba keeps what it compiled between processes, until the formulas change."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("numba")

LOOKED_UP = """
import numpy as np
from roadlang.simulation.vehicles import compiled
if {digest!r}:
    compiled._digest = lambda: {digest!r}
loop = compiled.lookup_kernel()
first, out = np.zeros(2, np.int64), np.empty(2)
numbers = np.array([[3.0, 3.0], [0.0, 0.0], [1.0, 1.0], [1.0, 1.0]])
loop(np.array([5.0, 6.0, 7.0, 8.0]), first, np.array([1.5, 9.0]), first, numbers, out)
print(out.tolist(), sum(loop.stats.cache_hits.values()))
"""


NO_FOLDER = """
from numba.core import caching
caching.CacheImpl._locator_classes = []
"""


def looked_up(cache: Path | None, digest: str = "") -> str:
    """What the loop gives in a process of its own, and how often it was found in the cache. None:
    there is no folder for one."""
    code = NO_FOLDER if cache is None else ""
    command = [sys.executable, "-c", code + LOOKED_UP.format(digest=digest)]
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(cache or "")}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return done.stdout.strip()


@pytest.mark.slow
def test_what_was_compiled_is_used_again_until_the_formulas_change(tmp_path: Path) -> None:
    assert looked_up(tmp_path) == "[6.0, 8.0] 0"
    assert looked_up(tmp_path) == "[6.0, 8.0] 1"
    assert looked_up(tmp_path, digest="other formulas") == "[6.0, 8.0] 0"
    assert looked_up(tmp_path) == "[6.0, 8.0] 1"


@pytest.mark.slow
def test_without_a_folder_to_write_it_is_compiled_each_time() -> None:
    assert looked_up(None) == "[6.0, 8.0] 0"
