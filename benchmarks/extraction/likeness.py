"""Fit how much the network of a drawing, or of a map, is like roads, and say how it holds on
pictures left out.

    python -m benchmarks.extraction.likeness [--maps] --roads FOLDER ... --none FOLDER ...

The folders hold pictures of roads and pictures without any; photos and maps that roads leave are
passed over. With `--maps`, pictures in which roads were found by color are judged as maps, and all
others are passed over. The first lines are the constants `LIKENESS` or `MAP_LIKENESS` of
`roadlang_standard.extraction.doubts.road_likeness`; then how many of the networks are below each of
some log odds when they are left out of the fit, an eighth of the pictures at a time: of roads, of
no roads, and of those which the other rules left more than half sure.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from unittest.mock import patch

import cv2
import numpy as np

from benchmarks.extraction.calibration import Samples, fitted, stated_when_left_out
from roadlang.images.image_file import open_image
from roadlang.world.sources.pictures import picture_of
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extraction.doubts import drawn_confidence
from roadlang_standard.extraction.doubts.line_art import ends_at_rim
from roadlang_standard.extraction.doubts.road_likeness import (
    LIKENESS,
    MAP_LIKENESS,
    likeness_facts,
    map_facts,
)
from roadlang_standard.extraction.drawings import surface_roads
from roadlang_standard.extraction.networks.found_network import FoundNetwork

_HARD, _EASY = 3.0, 0.5
"""What is no road counts so many times if the other rules leave it sure, and if they do not."""
_RIDGE = 1.0
"""Of weights that are for one standard deviation of each of the facts."""
_ODDS = (-2.5, -2.0, -1.5, -1.0, -0.5, 0.0)


@dataclass(frozen=True)
class Judged:
    """The facts of a network, whether it is roads, and whether the other rules leave it sure."""

    facts: tuple[float, ...]
    is_roads: bool
    sure: bool


def main() -> None:
    """Print the fit and how it holds."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.extraction.likeness")
    parser.add_argument("--roads", nargs="+", type=Path, required=True)
    parser.add_argument("--none", nargs="+", type=Path, required=True)
    parser.add_argument("--maps", action="store_true", help="fit MAP_LIKENESS")
    told = parser.parse_args()
    cv2.setNumThreads(1)
    judged = [
        each
        for folders, is_roads in ((told.roads, True), (told.none, False))
        for folder in folders
        for path in sorted(folder.iterdir())
        if path.suffix in (".png", ".jpg")
        for each in _judged(path, is_roads, told.maps)
    ]
    report(judged, MAP_LIKENESS if told.maps else LIKENESS)


def report(judged: list[Judged], names: Iterable[str] = LIKENESS) -> None:
    """Print what is fitted to these networks, each once; roads that the other rules doubt are no
    examples."""
    judged = [one for one in dict.fromkeys(judged) if one.sure or not one.is_roads]
    is_roads = np.array([one.is_roads for one in judged])
    sure = np.array([one.sure for one in judged])
    weight = np.where(is_roads, 0.0, np.where(sure, _HARD, _EASY))
    weight[is_roads] = weight.sum() / max(1, np.count_nonzero(is_roads))
    index = np.arange(len(judged), dtype=float)
    facts = np.array([one.facts for one in judged])
    samples = Samples(
        facts, np.zeros(len(judged)), is_roads, weight, index, index, np.zeros(len(judged))
    )
    ridge = _RIDGE * facts.var(axis=0) + 1e-9
    for name, value in zip(names, fitted(samples, ridge).tolist(), strict=True):
        print(f'    "{name}": {value:.2f},')
    kinds = {"roads": is_roads, "none": ~is_roads, "none, sure": ~is_roads & sure}
    print("below   " + "".join(f"{name:>12s}" for name in kinds))
    print("of      " + "".join(f"{np.count_nonzero(kind):12d}" for kind in kinds.values()))
    believed = stated_when_left_out(samples, 0, lambda rest: fitted(rest, ridge))
    odds = np.log(believed / np.maximum(1 - believed, 1e-12))
    for least in _ODDS:
        counts = [np.count_nonzero(odds[kind] < least) for kind in kinds.values()]
        print(f"{least:6.1f}  " + "".join(f"{count:12d}" for count in counts))


def _judged(path: Path, is_roads: bool, maps: bool) -> list[Judged]:
    """The network of a picture, if it is judged by its likeness: none or one. A map that is doubted
    would be read as a drawing: what the model says now must not decide that."""
    sure = patch.object(drawn_confidence, "sure_like_map", lambda *_: 1.0)
    with sure, _networks() as networks:
        opened = open_image(path, str(path), None)
        Auto().extract(picture_of(opened.shown, opened.scale or 1.0, str(path)))
    if maps:
        return [
            judged_map(found, is_roads) for found, drawn in networks[-1:] if is_map(found, drawn)
        ]
    return [judged_network(*network, is_roads) for network in networks[-1:] if is_drawn(*network)]


def is_map(found: FoundNetwork, drawn: bool) -> bool:
    """Whether a network is judged as a map: its roads were found by color."""
    return bool(found.roads) and not drawn


def is_drawn(found: FoundNetwork, drawn: bool) -> bool:
    """Whether a network is judged as a drawing: it is one, or hardly any road leaves the map."""
    return bool(found.roads) and (drawn or exits(found) <= drawn_confidence.OPEN)


def exits(found: FoundNetwork) -> int:
    """The ends of roads at the border of the picture."""
    at_rim = (ends_at_rim(road, found.mask.shape) for road in found.roads)
    return sum(int(ends.sum()) for ends in at_rim)


def judged_map(found: FoundNetwork, is_roads: bool) -> Judged:
    """The facts of a map, and what the other rules say of it."""
    with patch.object(drawn_confidence, "sure_like_map", lambda *_: 1.0):
        others = drawn_confidence.with_doubts(found, drawn=False)
    sure = max(road.confidence for road in others.roads) > 0.5
    facts = map_facts(found)
    return Judged(tuple(round(facts[name], 6) for name in MAP_LIKENESS), is_roads, sure)


def judged_network(found: FoundNetwork, drawn: bool, is_roads: bool) -> Judged:
    """Its facts, and what the other rules say of it."""
    with patch.object(drawn_confidence, "sure_by_likeness", lambda *_: 1.0):
        others = drawn_confidence.with_doubts(found, drawn)
    sure = max(road.confidence for road in others.roads) > 0.5
    facts = likeness_facts(found, colored=not drawn)
    return Judged(tuple(round(facts[name], 6) for name in LIKENESS), is_roads, sure)


@contextmanager
def _networks() -> Iterator[list[tuple[FoundNetwork, bool]]]:
    """The networks that are judged meanwhile, and whether they were drawn."""
    seen: list[tuple[FoundNetwork, bool]] = []
    judge = drawn_confidence.with_doubts

    def noted(found: FoundNetwork, drawn: bool = True, measured: bool = True) -> FoundNetwork:
        seen.append((found, drawn))
        return judge(found, drawn, measured)

    with patch.object(surface_roads, "with_doubts", noted):
        yield seen


if __name__ == "__main__":
    main()
