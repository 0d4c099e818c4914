"""Sequential search: one stream of candidates for all scenes, as grids and sequences have it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import read_only
from ..judging.acceptance import Acceptance
from ..plugins.guard import wrong_result
from ..plugins.results import real_numbers
from .accepted import Accepted
from .effort import attempts_of, batch_size, count_or_none
from .rejection_report import RejectionStats
from .samplers import DrawnPlace, drawn_values

_FEWEST = 32
"""Candidates that are judged at once, however few are wanted"""


@dataclass(frozen=True)
class StreamResult:
    """`missing`: the scenes that no candidate was left for."""

    wanted: int
    accepted: tuple[Accepted, ...]
    missing: tuple[int, ...]
    stats: RejectionStats


def accepted_of_stream(
    acceptance: Acceptance, sampler: KindInstance, seed: int, n: int | None
) -> StreamResult:
    """Scene i is the i-th accepted candidate of the stream. `n` None: all of a finite stream, one
    of an endless one."""
    draws = drawn_values(acceptance.scenario)
    with sampler.guarded:
        size = count_or_none(sampler.kind.size(draws), "size")
    wanted = n if n is not None else (size or 1)
    limit = size if size is not None else attempts_of(sampler, acceptance)
    stats = RejectionStats.empty(len(acceptance.requirements))
    accepted: list[Accepted] = []
    for candidates in _stream(acceptance, sampler, draws, seed, limit, 2 * wanted):
        judged = acceptance.judge(candidates)
        rows = np.flatnonzero(judged.accepted)[: wanted - len(accepted)]
        for row in rows:
            accepted.append(Accepted.of(candidates, judged, int(row), len(accepted)))
        last = int(rows[-1]) if len(accepted) == wanted and len(rows) else candidates.count
        stats.count(judged, np.arange(candidates.count) <= last)
        if len(accepted) == wanted:
            break
    is_short = bool(accepted) and (size is None or n is not None)
    missing = range(len(accepted), wanted) if is_short else range(0 if accepted else 1)
    return StreamResult(wanted, tuple(accepted), tuple(missing), stats)


def first_of_stream(
    acceptance: Acceptance, sampler: KindInstance, seed: int, count: int
) -> CandidateBatch:
    """The first `count` candidates of the stream, or fewer where it ends before."""
    draws = drawn_values(acceptance.scenario)
    with sampler.guarded:
        size = count_or_none(sampler.kind.size(draws), "size")
    limit = count if size is None else min(count, size)
    return next(_stream(acceptance, sampler, draws, seed, limit, count))


def _stream(
    acceptance: Acceptance,
    sampler: KindInstance,
    draws: Sequence[DrawnPlace],
    seed: int,
    limit: int,
    most: int,
) -> Iterator[CandidateBatch]:
    width = min(batch_size(acceptance), max(most, _FEWEST))
    for start in range(0, limit, width):
        indices = read_only(np.arange(start, min(start + width, limit)))
        with sampler.guarded:
            result = sampler.kind.points(indices, draws, seed)
        points = real_numbers(result, "points", sampler.entry, sampler.call.span)
        _check_points(points, sampler, len(indices), len(draws))
        coordinates = {draw.place: points[:, column] for column, draw in enumerate(draws)}
        yield CandidateBatch(
            acceptance.scenario, seed, np.zeros_like(indices), indices, coordinates
        )


def _check_points(
    points: NDArray[np.float64], sampler: KindInstance, count: int, dimensions: int
) -> None:
    if points.shape != (count, dimensions) or not ((points >= 0) & (points <= 1)).all():
        raise wrong_result(
            sampler.entry,
            sampler.call.span,
            f"gave points of shape {points.shape} or beyond [0, 1]",
        )
