"""Checking a scene file imports nothing heavy, and `--help` nothing that commands need to run."""

from __future__ import annotations

import subprocess
import sys

_SCRIPT = """
import sys
from pathlib import Path
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
text = '''
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
road bent from main { perturb with random_walk {
  amplitude: normal(1m, 0.5m, within: [0m, 2m]), correlation: 20m..60m } }
require phi: always (deviation(bent, main) < 10m and abs(curvature(bent)) < 0.1/m)
agent ego is choice(car, truck) on bent at 5m { drive with pure_pursuit { speed: 12m/s } }
expect in_lane: always (abs(ego.cross_track_error) < 1.5m)
sample with grid { steps: 5 }
emit json
emit svg
'''
scenario, found = check_text(text, Path("scene.rl"), {}, load_registry())
assert scenario is not None, found
heavy = {"numpy", "scipy", "cv2", "lark", "yaml", "msgspec"} & set(sys.modules)
assert not heavy, heavy
"""


def test_no_heavy_import() -> None:
    done = subprocess.run([sys.executable, "-c", _SCRIPT], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


_HELP = """
import sys
from roadlang.cli.main import run
assert run(["--help"]) == 0
needless = {"roadlang.api", "roadlang.plugins.kinds", "roadlang.geometry", "numpy",
            "urllib.request", "concurrent.futures", "asyncio"} & set(sys.modules)
assert not needless, needless
"""


def test_help_imports_no_kinds() -> None:
    done = subprocess.run([sys.executable, "-c", _HELP], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "watch" in done.stdout
