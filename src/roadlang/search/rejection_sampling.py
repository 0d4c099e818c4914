"""Random search: a stream of attempts for each scene, judged in batches."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import Floats, Integers
from ..judging.acceptance import Acceptance
from .accepted import Accepted
from .effort import attempts_of, batch_size, crowded_attempts, later_batch_size
from .rejection_report import RejectionStats

Propose = Callable[[CandidateBatch], Mapping[str, Floats]]
"""The coordinates, by name, that candidates are to have."""

MANY = 16
"""Scenes of which the first attempt alone is judged at first: it is all that many of them need."""


def accepted_attempts(
    acceptance: Acceptance,
    sampler: KindInstance,
    seed: int,
    scenes: Sequence[int],
    attempts: range | None = None,
    propose: Propose | None = None,
    crowded: dict[int, int] | None = None,
) -> tuple[list[Accepted], RejectionStats]:
    """The first accepted of the `attempts` of each scene (all that it has, unless they are given),
    and the counts up to it. Attempts draw evenly, or have the coordinates that are proposed.

    `crowded`: the attempts of each scene that failed for want of room before; they are added to.
    """
    limit, together = attempts_of(sampler, acceptance), batch_size(acceptance)
    later = together if propose is not None else later_batch_size(acceptance)
    first, end = (0, limit) if attempts is None else (attempts.start, min(attempts.stop, limit))
    stats = RejectionStats.empty(len(acceptance.requirements))
    accepted: dict[int, Accepted] = {}
    crowded, most = {} if crowded is None else crowded, crowded_attempts(acceptance.scenario)
    pending, start = [s for s in scenes if crowded.get(s, 0) < most], first
    while pending and start < end:
        width = max(1, together // len(pending))
        one_each = start == 0 and len(pending) >= MANY
        width = min(width, end - start, 1 if one_each else 4 * start + 4)
        tries = np.arange(start, start + width)
        candidates = _candidates(acceptance, seed, pending, tries, propose)
        left = np.array([most - crowded.get(scene, 0) for scene in pending])
        judged = acceptance.judge(candidates, candidates.scenes, np.repeat(left, width))
        fine = judged.accepted.reshape(len(pending), width)
        failed = np.cumsum(acceptance.rejected_last(judged).reshape(fine.shape), axis=1)
        ended = fine | (failed >= left[:, None])
        last = np.where(ended.any(axis=1), ended.argmax(axis=1), width - 1)
        stats.count(judged, (np.arange(width) <= last[:, None]).reshape(-1))
        for row, scene in enumerate(pending):
            crowded[scene] = crowded.get(scene, 0) + int(failed[row, last[row]])
            if fine[row, last[row]]:
                place = row * width + int(last[row])
                accepted[scene] = Accepted.of(candidates, judged, place, scene)
        pending = [s for s in pending if s not in accepted and crowded[s] < most]
        start, together = start + width, later
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
