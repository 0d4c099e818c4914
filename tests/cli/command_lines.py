"""Runs command lines in this process, as a user types them."""

from __future__ import annotations

import io
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path

import pytest

SCENE = """\
road main { draw with waypoints { points: [(0m, 0m), (80m, 10m), (160m, -10m), (240m, 30m)] } }
road bent from main { perturb with sine { amplitude: 0m..6m, wavelength: 80m..200m } }
require near: always (deviation(bent, main) < 3m)
emit json
emit svg
"""


@dataclass(frozen=True)
class Done:
    """What a command left behind."""

    returncode: int
    stdout: str
    stderr: str


def roadlang(*arguments: str, cwd: Path, **environment: str) -> Done:
    """Run a command line in `cwd`, in this process."""
    from roadlang.cli.main import run

    out, err = io.StringIO(), io.StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(err):
        patch.chdir(cwd)
        for name, value in environment.items():
            patch.setenv(name, value)
        code = run(list(arguments))
    return Done(code, out.getvalue(), err.getvalue())
