"""Confidence of roads against the truth: what is fitted, and how it holds on photos left out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from benchmarks.extraction.scores import Case
from roadlang.geometry import Booleans, Floats
from roadlang_standard.extraction.networks.found_network import FoundNetwork
from roadlang_standard.extraction.photos.photo_confidence import RoadFacts, road_facts

NAMES = ("least", "evidence", "wide")
"""The fitted log odds, as in `photo_confidence`."""
_RADIUS = 3.0
"""Pixels, times the scale of the case, within which a road is right."""
_FOLDS, _SHRINKS, _ROUNDS = 8, 4, 40
_EDGES = (0.0, 0.5, 0.7, 0.85, 1.01)


@dataclass(frozen=True)
class Samples:
    """Points of roads, n of them: what their confidence depends on (n, 3), as `NAMES` say, and the
    given log odds (n,); whether they are right; the pixels of road at each; the index of the road,
    of the group that is left out together, and of the source of its photo."""

    facts: Floats
    given: Floats
    right: Booleans
    length: Floats
    road: Floats
    group: Floats
    source: Floats

    def of(self, chosen: Booleans) -> Samples:
        """Those of the points that are chosen (n,)."""
        return Samples(*(values[chosen] for values in vars(self).values()))


@dataclass(frozen=True)
class Band:
    """Of what is stated to be this sure: the share of all length, mean confidence, share right."""

    share: float
    stated: float
    right: float


def samples_of(found: FoundNetwork, case: Case, road: int, group: int, source: int) -> Samples:
    """The points of the roads of one photo, whose confidences are evidence still; its roads are
    numbered from `road`."""
    away = distance_transform_edt(~case.line) if case.line.any() else np.full(case.line.shape, 1e6)
    parts = [
        _of_road(line.points, facts, away <= _RADIUS * case.scale, road + i, group, source)
        for i, (line, facts) in enumerate(zip(found.roads, road_facts(found), strict=True))
    ]
    return joined(parts)


def _of_road(
    points: Floats, facts: RoadFacts, near: Booleans, road: int, group: int, source: int
) -> Samples:
    count = len(points)
    step = np.hypot(*np.diff(points, axis=0).T)
    length = (np.append(0.0, step) + np.append(step, 0.0)) / 2
    x, y = np.clip(np.round(points).astype(int), 0, np.array(near.shape[::-1]) - 1).T
    columns = (np.ones(count), facts.evidence, np.full(count, facts.wide))
    ids = (np.full(count, float(value)) for value in (road, group, source))
    given = np.full(count, facts.given)
    return Samples(np.column_stack(columns), given, near[y, x], length, *ids)


def joined(parts: Sequence[Samples]) -> Samples:
    """All of them as one."""
    if not parts:
        empty = np.zeros(0)
        return Samples(np.zeros((0, len(NAMES))), empty, empty > 0, empty, empty, empty, empty)
    columns = zip(*(vars(part).values() for part in parts), strict=True)
    return Samples(*(np.concatenate(values) for values in columns))


def fitted(samples: Samples, ridge: Floats | float = 1e-6) -> Floats:
    """The log odds (k,) of the facts, as `NAMES`, under which what is right is likeliest, each
    pixel of road counting the same: logistic regression by Newton's method. `ridge`, one for each
    fact or for all, keeps them small."""
    weights = np.zeros(samples.facts.shape[1])
    for _ in range(_ROUNDS):
        sure = stated(samples, weights)
        slope = samples.facts.T @ (samples.length * (sure - samples.right)) + ridge * weights
        pull = samples.length * sure * (1 - sure)
        bend = (samples.facts * pull[:, None]).T @ samples.facts + ridge * np.eye(len(weights))
        step = np.linalg.solve(bend, slope)
        weights = weights - step
        if np.abs(step).max() < 1e-8:
            break
    return weights


def shrunk(samples: Samples) -> Floats:
    """The log odds (k,) as fitted, drawn together so far that photos left out of the fit are stated
    without bias: fitted to few photos, they are too sure on both sides.

    The log odds of points left out are multiplied and shifted as is likeliest (van Houwelingen and
    le Cessie 1990), as a mean over ways to leave them out.
    """
    corrections = [_correction(samples, seed) for seed in range(_SHRINKS)]
    shift, factor = np.mean(corrections, axis=0)
    weights = factor * fitted(samples)
    weights[0] += shift
    return np.asarray(weights)


def _correction(samples: Samples, seed: int) -> Floats:
    """The likeliest shift and factor of the log odds of points that are left out of the fit."""
    fold = _folds(samples, seed)
    odds = np.zeros(len(fold))
    for left_out in np.unique(fold):
        weights = fitted(samples.of(fold != left_out))
        odds[fold == left_out] = samples.facts[fold == left_out] @ weights
    return fitted(replace(samples, facts=np.column_stack([np.ones(len(odds)), odds])))


def _folds(samples: Samples, seed: int) -> NDArray[np.intp]:
    """With which eighth of the groups of its source each point (n,) is left out."""
    rng = np.random.default_rng(seed)
    fold = np.zeros(len(samples.length), np.intp)
    for source in np.unique(samples.source):
        groups = rng.permutation(np.unique(samples.group[samples.source == source]))
        for index, group in enumerate(groups):
            fold[samples.group == group] = index % _FOLDS
    return fold


def stated(samples: Samples, weights: Floats) -> Floats:
    """The confidences (n,) under fitted log odds (k,)."""
    return np.asarray(1 / (1 + np.exp(-(samples.facts @ weights + samples.given))))


def stated_when_left_out(
    samples: Samples, seed: int, fit: Callable[[Samples], Floats] = fitted
) -> Floats:
    """The confidences (n,), each under the `fit` without an eighth of the groups of every source,
    its own among them; the seed says which."""
    sure = np.zeros(len(samples.length))
    fold = _folds(samples, seed)
    for left_out in np.unique(fold):
        weights = fit(samples.of(fold != left_out))
        sure[fold == left_out] = stated(samples.of(fold == left_out), weights)
    return sure


def by_stretch(sure: Floats, right: Floats, length: Floats) -> list[Band]:
    """Below 50 %, from 50 to 70 %, from 70 to 85 %, and above."""
    bands = []
    for low, high in pairwise(_EDGES):
        part = np.where((sure >= low) & (sure < high), length, 0.0)
        total = max(float(part.sum()), 1e-9)
        share = float(part.sum() / max(float(length.sum()), 1e-9))
        bands.append(Band(share, float(sure @ part) / total, float(right @ part) / total))
    return bands


def by_road(sure: Floats, samples: Samples) -> list[Band]:
    """The same for whole roads, whose confidence is the mean of those at their points."""
    _, road = np.unique(samples.road, return_inverse=True)
    length = np.bincount(road, samples.length)
    hits = np.bincount(road, samples.length * samples.right)
    mean = np.bincount(road, sure) / np.bincount(road)
    return by_stretch(mean, hits / np.maximum(length, 1e-9), np.asarray(length, float))
