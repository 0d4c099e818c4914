"""Random search: a stream of attempts for each scene, judged in batches."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import Floats, Integers
from ..judging.acceptance import Acceptance
from .accepted import Accepted
from .effort import attempts_of, batch_size
from .rejection_report import RejectionStats

Propose = Callable[[CandidateBatch], Mapping[str, Floats]]
"""The coordinates, by name, that candidates are to have."""

CROWDED = 40
"""Attempts of a scene that fail only because something finds no room, after which it is given up:
each has been arranged many times."""


def accepted_attempts(
    acceptance: Acceptance,
    sampler: KindInstance,
    seed: int,
    scenes: Sequence[int],
    attempts: range | None = None,
    propose: Propose | None = None,
) -> tuple[list[Accepted], RejectionStats]:
    """The first accepted of the `attempts` of each scene (all that it has, unless they are given),
    and the counts up to it. Attempts draw evenly, or have the coordinates that are proposed."""
    limit, together = attempts_of(sampler, acceptance), batch_size(acceptance)
    first, end = (0, limit) if attempts is None else (attempts.start, min(attempts.stop, limit))
    stats = RejectionStats.empty(len(acceptance.requirements))
    accepted: dict[int, Accepted] = {}
    crowded: dict[int, int] = {}
    pending, start = list(scenes), first
    while pending and start < end:
        width = max(1, together // len(pending))
        width = min(width, end - start, 4 * start + 4)
        tries = np.arange(start, start + width)
        candidates = _candidates(acceptance, seed, pending, tries, propose)
        judged = acceptance.judge(candidates, candidates.scenes)
        counted = np.ones(candidates.count, dtype=bool)
        fine = judged.accepted.reshape(len(pending), width)
        for row, scene in enumerate(pending):
            if fine[row].any():
                place = row * width + int(fine[row].argmax())
                accepted[scene] = _accepted(candidates, place)
                counted[place + 1 : (row + 1) * width] = False
        stats.count(judged, counted)
        last = acceptance.rejected_last(judged).reshape(len(pending), width).sum(axis=1)
        for scene, number in zip(pending, last.tolist(), strict=True):
            crowded[scene] = crowded.get(scene, 0) + number
        pending = [s for s in pending if s not in accepted and crowded[s] < CROWDED]
        start += width
    return [accepted[scene] for scene in sorted(accepted)], stats


def _candidates(
    acceptance: Acceptance,
    seed: int,
    scenes: Sequence[int],
    tries: Integers,
    propose: Propose | None,
) -> CandidateBatch:
    """The attempts `tries` of each scene."""
    each = np.repeat(scenes, len(tries)), np.tile(tries, len(scenes))
    even = CandidateBatch(acceptance.scenario, seed, *each)
    if propose is None:
        return even
    return CandidateBatch(acceptance.scenario, seed, *each, propose(even))


def _accepted(candidates: CandidateBatch, row: int) -> Accepted:
    scene, attempt = int(candidates.scenes[row]), int(candidates.attempts[row])
    chosen = {name: values[row : row + 1] for name, values in candidates.coordinates.items()}
    return Accepted(scene, scene, attempt, chosen)
