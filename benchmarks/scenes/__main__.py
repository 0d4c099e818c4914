"""Milliseconds of processor time for each scene: sampled, and written as JSON and as SVG.

python -m benchmarks.scenes [COUNT]
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

import roadlang

HAIRPIN = Path(__file__).parents[2] / "examples" / "hairpin.rl"
TRIVIAL = """
road main { draw with segments { pieces: [straight(200m)] } }
road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 60m..200m } }
agent ego is car on bent at 5m { drive with pure_pursuit { speed: 12m/s } }
"""
THINGS = """
road main { draw with segments { pieces: [straight(400m), arc(300m, 90deg), straight(400m)] } }
object trees is tree on main at random {
  count: 1000, side: choice(left, right), offset: 4m..200m
}
"""


def main() -> int:
    """Print a line for each kind of scene."""
    count = int([*sys.argv[1:], "500"][0])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for title, text, share in (("trivial", TRIVIAL, 1), ("1,000 things", THINGS, 10)):
            (folder / f"{share}.rl").write_text(text)
            _measure(title, folder / f"{share}.rl", max(count // share, 2), folder)
        _measure("hairpin", HAIRPIN, max(count // 3, 2), folder)
    return 0


def _measure(title: str, file: Path, count: int, folder: Path) -> None:
    loaded = roadlang.load(file)
    loaded.sample(2, seed=5)
    start = time.process_time()
    scenes = loaded.sample(count, seed=1)
    spent = {"sampled": time.process_time() - start}
    for kind in ("json", "svg"):
        start = time.process_time()
        scenes.emit(folder / f"{title}-{kind}", [kind])
        spent[kind] = time.process_time() - start
    shown = "   ".join(f"{name} {1e3 * seconds / count:.2f} ms" for name, seconds in spent.items())
    print(f"{title:14} {shown}")


if __name__ == "__main__":
    sys.exit(main())
