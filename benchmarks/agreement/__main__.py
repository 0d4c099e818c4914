"""How far the embedded engine and Godot agree: `python -m benchmarks.agreement`.

The friction of the embedded engine is fitted on the first scenes, and the agreement is reported on
scenes that had no part in that. Needs a Godot engine. Ends with 1 if a bar is missed.
"""

from __future__ import annotations

import argparse
import sys

from .drives import in_embedded, in_godot
from .measures import Agreement, Pair
from .scenes import random_scenes

GRIPS = (0.94, 0.97, 1.0, 1.03, 1.06)


def fitted_grip(count: int) -> float:
    """The factor of friction with which the embedded engine is most like Godot."""
    scenes = list(random_scenes(count))
    real = in_godot(scenes)
    found: dict[float, Agreement] = {}
    for grip in GRIPS:
        found[grip] = Agreement.of(map(Pair.of, in_embedded(scenes, grip), real))
        print(f"fit, friction x {grip}: {found[grip]}")
    best = max(found, key=lambda grip: _score(found[grip], grip))
    print(f"fitted: friction x {best}")
    return best


def _score(one: Agreement, grip: float) -> tuple[float, float, float]:
    return one.right_failing + one.right_safe, -round(one.speed_rmse, 2), -abs(grip - 1.0)


def main() -> int:
    """Print the agreement; 1 if a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fit", type=int, default=20, help="scenes to fit on")
    parser.add_argument("--unseen", type=int, default=20, help="scenes to report on")
    parser.add_argument("--each", action="store_true", help="a line for each scene")
    given = parser.parse_args()
    grip = fitted_grip(given.fit)
    scenes = list(random_scenes(given.unseen, given.fit))
    pairs = list(map(Pair.of, in_embedded(scenes, grip), in_godot(scenes)))
    for number, pair in enumerate(pairs if given.each else (), start=given.fit):
        alone = Agreement.of([pair])
        print(number, *pair.fails, f"{alone.speed_rmse:.2f} {alone.lateral_correlation:.2f}")
    found = Agreement.of(pairs)
    print(f"unseen: {found}")
    met = (
        found.speed_rmse <= 1.5
        and found.lateral_correlation >= 0.5
        and min(found.right_failing, found.right_safe) >= 0.8
        and 0.3 * found.scenes <= found.failing <= 0.7 * found.scenes
    )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
