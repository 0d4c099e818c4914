"""Fit the confidence of roads of photos, and say how it holds on photos left out.

    python -m benchmarks.extraction.confidence MANIFEST [MANIFEST ...]

The photos and their truth are listed as for `benchmarks.extraction`. Photos with the same
`source_path`, parts of one picture, are left out together; those with the same `source_repo`, else
those of one manifest, are one source. The first line are the constants of
`roadlang_standard.extraction.photos.photo_confidence`; then, of each band of confidence, the share
of the length of all roads, and stated and right in percent.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import cv2
import numpy as np

from benchmarks.extraction.calibration import (
    NAMES,
    Band,
    Samples,
    by_road,
    by_stretch,
    joined,
    samples_of,
    shrunk,
    stated_when_left_out,
)
from benchmarks.extraction.scores import Case
from roadlang.geometry import Booleans, Floats
from roadlang_standard.extraction.photos.aerial import roads_of_photo

_DRAWN = "track-drawing"
_SEEDS = range(6)


def main() -> None:
    """Print the fit and the bands."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.extraction.confidence")
    parser.add_argument("manifests", nargs="+", type=Path)
    told = parser.parse_args()
    cv2.setNumThreads(1)
    samples, sources = _read(told.manifests)
    print(", ".join(f"{n} {v:.3f}" for n, v in zip(NAMES, shrunk(samples), strict=True)))
    sure = [stated_when_left_out(samples, seed, shrunk) for seed in _SEEDS]
    everything = np.ones(len(samples.length), bool)
    _print("all sources", samples, sure, everything)
    for index, source in enumerate(sources):
        _print(source, samples, sure, samples.source == index)


def _read(manifests: list[Path]) -> tuple[Samples, list[str]]:
    """The points of the roads of all photos, and the names of the sources."""
    parts: list[Samples] = []
    groups: list[str] = []
    sources: list[str] = []
    roads = 0
    for manifest in manifests:
        for entry in json.loads(manifest.read_text())["images"]:
            if entry.get("kind") == _DRAWN:
                continue
            image = cv2.imread(str(manifest.parent / entry["file"]))
            mask = cv2.imread(str(manifest.parent / entry["mask"]), cv2.IMREAD_GRAYSCALE)
            case = Case.of_mask(image, mask, entry.get("upsampled", 1))
            source = _index(sources, entry.get("source_repo", str(manifest)))
            group = _index(groups, f"{source} {entry.get('source_path', entry['file'])}")
            found = roads_of_photo(image)
            parts.append(samples_of(found, case, roads, group, source))
            roads += len(found.roads)
    return joined(parts), sources


def _index(names: list[str], name: str) -> int:
    """Where a name is in the list, to which it is added if it is new."""
    if name not in names:
        names.append(name)
    return names.index(name)


def _print(title: str, samples: Samples, sure: list[Floats], chosen: Booleans) -> None:
    """The bands of the chosen points (n,), means over the ways to leave photos out."""
    some = samples.of(chosen)
    print(title)
    stretches = [by_stretch(one[chosen], some.right.astype(float), some.length) for one in sure]
    roads = [by_road(one[chosen], some) for one in sure]
    for name, rounds in (("stretches", stretches), ("roads", roads)):
        bands = [_mean(list(band)) for band in zip(*rounds, strict=True)]
        columns = (f"{b.share:6.0%} {100 * b.stated:5.1f} {100 * b.right:5.1f}" for b in bands)
        print(f"  {name:10s}" + "  ".join(columns))


def _mean(bands: list[Band]) -> Band:
    """Of several, weighted by length."""
    share = np.array([band.share for band in bands])
    each = share / max(float(share.sum()), 1e-9)
    return Band(
        float(share.mean()),
        float(each @ [band.stated for band in bands]),
        float(each @ [band.right for band in bands]),
    )


if __name__ == "__main__":
    main()
