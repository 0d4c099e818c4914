"""Results do not depend on how many cores a machine has."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

SHOW = """
import os, sys
from roadlang.cli.main import main
try:
    main(["--version"])
except SystemExit:
    print(os.environ["OPENBLAS_NUM_THREADS"], "numpy" in sys.modules)
"""


@pytest.mark.parametrize(("before", "after"), [(None, "1"), ("2", "2")])
def test_a_command_adds_up_matrices_in_one_thread_unless_told_otherwise(
    before: str | None, after: str
) -> None:
    environment = {k: v for k, v in os.environ.items() if k != "OPENBLAS_NUM_THREADS"}
    if before is not None:
        environment["OPENBLAS_NUM_THREADS"] = before
    done = subprocess.run(
        [sys.executable, "-c", SHOW], capture_output=True, text=True, env=environment, check=True
    )
    assert done.stdout.split()[-2:] == [after, "False"]
