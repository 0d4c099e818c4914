"""Random search: a stream of attempts for each scene, judged in batches."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.kind_instance import KindInstance
from ..judging.acceptance import Acceptance
from .accepted import Accepted
from .effort import attempts_of, batch_size
from .rejection_report import RejectionStats

CROWDED = 40
"""Attempts of a scene that fail only because something finds no room, after which it is given up:
each has been arranged many times."""


def accepted_attempts(
    acceptance: Acceptance,
    sampler: KindInstance,
    seed: int,
    scenes: Sequence[int],
    first_attempt: int = 0,
) -> tuple[list[Accepted], RejectionStats]:
    """The first accepted attempt of each scene from `first_attempt` on, and the counts up to it."""
    attempts, together = attempts_of(sampler, acceptance), batch_size(acceptance)
    stats = RejectionStats.empty(len(acceptance.requirements))
    accepted: dict[int, int] = {}
    crowded: dict[int, int] = {}
    pending, start = list(scenes), first_attempt
    while pending and start < attempts:
        width = max(1, together // len(pending))
        width = min(width, attempts - start, 4 * start + 4)
        tries = np.arange(start, start + width)
        candidates = CandidateBatch(
            acceptance.scenario, seed, np.repeat(pending, width), np.tile(tries, len(pending))
        )
        judged = acceptance.judge(candidates, candidates.scenes)
        counted = np.ones(candidates.count, dtype=bool)
        fine = judged.accepted.reshape(len(pending), width)
        for row, scene in enumerate(pending):
            if fine[row].any():
                first = int(fine[row].argmax())
                accepted[scene] = start + first
                counted[row * width + first + 1 : (row + 1) * width] = False
        stats.count(judged, counted)
        last = acceptance.rejected_last(judged).reshape(len(pending), width).sum(axis=1)
        for scene, number in zip(pending, last.tolist(), strict=True):
            crowded[scene] = crowded.get(scene, 0) + number
        pending = [s for s in pending if s not in accepted and crowded[s] < CROWDED]
        start += width
    return [Accepted(scene, scene, accepted[scene]) for scene in sorted(accepted)], stats
