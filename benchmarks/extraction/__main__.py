"""Score the extractor and its rivals on pictures with truth.

    python -m benchmarks.extraction MANIFEST          # pictures listed in a manifest.json
    python -m benchmarks.extraction --rendered 8      # scenes of our own renderer

Columns: relaxed precision, recall and F1 at 3 and 5 px, Wiedemann's completeness, correctness and
quality with a 5 px buffer, connectivity (like APLS), CPU seconds per megapixel.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import cv2
import numpy as np

from benchmarks.extraction.baselines import Lines, best_threshold, classical, paper_chain
from benchmarks.extraction.scores import COLUMNS, Case, relaxed_f1, score
from roadlang_standard.extraction.drawings.thresholding import ContourSteps, roads_by_contour
from roadlang_standard.extraction.photos.aerial import Request
from roadlang_standard.extraction.photos.crosscheck import checked_roads
from roadlang_standard.extraction.photos.road_net import road_net
from roadlang_standard.extraction.picture_kinds.picture_kind import picture_kind
from training.rendering.aerial import render_aerial

_PLANS = ("curve", "suburb", "grid", "rural", "village", "motorway", "bend", "roundabout")


def main() -> None:
    """Print a table per method."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.extraction", description=__doc__)
    parser.add_argument("manifest", nargs="?", type=Path)
    parser.add_argument("--rendered", type=int, default=0, help="so many scenes of our own")
    parser.add_argument("--only", choices=("ours", "all"), default="all")
    told = parser.parse_args()
    cv2.setNumThreads(1)
    cases = [*_listed(told.manifest)] if told.manifest else []
    cases += [*_rendered(told.rendered)]
    print(f"{'method':16s}{'pictures':>9s}" + "".join(f"{name:>10s}" for name in COLUMNS))
    for name, method in _methods(told.only).items():
        rows = [_timed(method, case) for case in cases]
        means = [float(np.mean([row[column] for row in rows])) for column in COLUMNS]
        print(
            f"{name:16s}{len(rows):9d}" + "".join(f"{value:10.3f}" for value in means), flush=True
        )


def _methods(only: str) -> dict[str, Callable[[Case], Lines]]:
    methods: dict[str, Callable[[Case], Lines]] = {"ours": _ours}
    if only == "all":
        methods["paper's chain"] = lambda case: paper_chain(case.image)
        methods["classical"] = lambda case: classical(case.image)
        methods["best threshold"] = lambda case: best_threshold(
            case.image, lambda lines: relaxed_f1(case, lines)
        )
    return methods


def _ours(case: Case) -> Lines:
    drawn = picture_kind(case.image).drawn
    found = (
        roads_by_contour(case.image, ContourSteps())
        if drawn
        else checked_roads(case.image, Request(), road_net())
    )
    return [road.points for road in found.roads]


def _timed(method: Callable[[Case], Lines], case: Case) -> dict[str, float]:
    begun = time.process_time()
    lines = method(case)
    seconds = time.process_time() - begun
    megapixels = case.image.shape[0] * case.image.shape[1] / 1e6
    return {**score(case, lines), "s/Mpx": seconds / megapixels}


def _listed(manifest: Path) -> Iterator[Case]:
    for entry in json.loads(manifest.read_text())["images"]:
        image = cv2.imread(str(manifest.parent / entry["file"]))
        mask = cv2.imread(str(manifest.parent / entry["mask"]), cv2.IMREAD_GRAYSCALE)
        yield Case.of_mask(image, mask, entry.get("upsampled", 1))


def _rendered(count: int) -> Iterator[Case]:
    for index in range(count):
        drawn = render_aerial(_PLANS[index % len(_PLANS)], 5000 + index, 512)
        lines = [np.asarray(line) for line in drawn.truth.polylines()]
        yield Case.of_lines(drawn.image, lines)


if __name__ == "__main__":
    main()
