"""The search for accepted candidates: a stream for each scene, or one stream for all."""

from __future__ import annotations

import operator
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate.building import KindInstance, build
from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scene import Scene
from ..ir.values import Draw
from ..judging.acceptance import Judge
from ..plugins.guard import wrong_result
from .effort import attempts_of
from .rejection_report import RejectionStats

if TYPE_CHECKING:
    from .sampling import Progress
    from .workers import WorkerPool

BATCH = 512
"""Candidates judged at once: a signal of 500 stations then fits the second cache."""
BLOCK = 16
"""Scenes searched for together; the blocks are the same however many workers there are."""


@dataclass
class Found:
    """What a search came to."""

    wanted: int
    stats: RejectionStats
    scenes: list[Scene] = field(default_factory=list)
    missing: list[int] = field(default_factory=list)
    impossible: list[int] = field(default_factory=list)
    points: list[Any] = field(default_factory=list)

    @property
    def diversity(self) -> float | None:
        """Mean distance to the nearest accepted draw; None where that is undefined."""
        from .diversity import mean_nearest

        return mean_nearest(self.points)


def search(
    judge: Judge, seed: int, n: int | None, pool: WorkerPool, progress: Progress | None
) -> Found:
    """The first `n` scenes by the scenario's sampler."""
    from .sampling import sampler_call

    sampler = build(sampler_call(judge.scenario), judge.scenario.fixed, single=True)
    if sampler.kind.sequential:
        return _search_stream(judge, sampler, seed, n, pool, progress)
    return _search_scenes(judge, n or 1, pool, progress)


def _search_scenes(judge: Judge, n: int, pool: WorkerPool, progress: Progress | None) -> Found:
    """Scene 0 first and by itself: where it is given up, so is everything."""
    found = Found(n, RejectionStats.empty(len(judge.requirements)))
    blocks = [range(1)]
    blocks += [range(start, min(start + BLOCK, n)) for start in range(1, n, BLOCK)]
    for part in (blocks[:1], blocks[1:]):
        for scenes, missing, stats, points in pool.search(part):
            found.scenes.extend(scenes)
            found.missing.extend(missing)
            found.points.extend(points)
            found.stats.add(stats)
            if progress is not None:
                progress(len(found.scenes) + len(found.missing), n)
        if not found.scenes:
            found.missing = list(range(n))
            break
    return found


def accepted_attempts(
    judge: Judge, seed: int, scenes: Sequence[int], attempts: int
) -> tuple[dict[int, int], RejectionStats]:
    """The first accepted attempt of each scene, and the counts up to it."""
    stats = RejectionStats.empty(len(judge.requirements))
    accepted: dict[int, int] = {}
    pending, start = list(scenes), 0
    while pending and start < attempts:
        width = 1 if judge.one_by_one else max(1, BATCH // len(pending))
        width = min(width, attempts - start, 4 * start + 4)
        tries = np.arange(start, start + width)
        candidates = CandidateBatch(
            judge.scenario, seed, np.repeat(pending, width), np.tile(tries, len(pending))
        )
        judged = judge.judge(candidates)
        counted = np.ones(candidates.count, dtype=bool)
        fine = judged.accepted.reshape(len(pending), width)
        for row, scene in enumerate(pending):
            if fine[row].any():
                first = int(fine[row].argmax())
                accepted[scene] = start + first
                counted[row * width + first + 1 : (row + 1) * width] = False
        stats.count(judged, counted)
        pending = [scene for scene in pending if scene not in accepted]
        start += width
    return accepted, stats


def _search_stream(
    judge: Judge,
    sampler: KindInstance,
    seed: int,
    n: int | None,
    pool: WorkerPool,
    progress: Progress | None,
) -> Found:
    """Scene i is the i-th accepted candidate of one stream."""
    draws = drawn_values(judge.scenario)
    with sampler.guarded:
        size = _size(sampler.kind.size(draws))
    wanted = n if n is not None else (size or 1)
    found = Found(wanted, RejectionStats.empty(len(judge.requirements)))
    limit = size if size is not None else attempts_of(sampler.kind, judge)
    picked: list[tuple[int, Mapping[str, Any]]] = []
    for candidates in _stream(judge, sampler, draws, seed, limit):
        judged = judge.judge(candidates)
        rows = np.flatnonzero(judged.accepted)[: wanted - len(picked)]
        picked.extend(
            (
                int(candidates.attempts[row]),
                {k: v[row : row + 1] for k, v in candidates.given.items()},
            )
            for row in rows
        )
        last = int(rows[-1]) if len(picked) == wanted and len(rows) else candidates.count
        found.stats.count(judged, np.arange(candidates.count) <= last)
        if len(picked) == wanted:
            break
    for scene in pool.instantiate(picked):
        found.scenes.append(scene)
        if progress is not None:
            progress(len(found.scenes), len(picked))
    found.points = [[float(v[0]) for v in given.values()] for _, given in picked]
    if size is None or n is not None:
        found.missing = list(range(len(picked), wanted))
    if not picked:
        found.missing = [0]
    return found


def _size(given: object) -> int | None:
    """A count or None. Raises `TypeError` for anything else, `ValueError` below 0."""
    size = None if given is None else operator.index(given)  # type: ignore[arg-type]
    if size is not None and size < 0:
        raise ValueError(f"its size is {size}")
    return size


def _stream(
    judge: Judge, sampler: KindInstance, draws: Sequence[DrawnPlace], seed: int, limit: int
) -> Iterator[CandidateBatch]:
    width = 1 if judge.one_by_one else BATCH
    for start in range(0, limit, width):
        indices = np.arange(start, min(start + width, limit))
        with sampler.guarded:
            points = np.asarray(sampler.kind.points(indices, draws, seed), dtype=float)
        _check_points(points, sampler, len(indices), len(draws))
        given = {draw.place: points[:, column] for column, draw in enumerate(draws)}
        yield CandidateBatch(judge.scenario, seed, np.zeros_like(indices), indices, given)


@dataclass(frozen=True)
class DrawnPlace:
    """A draw that is made once for each scene, as samplers see it."""

    draw: Draw
    scenario: IndexedScenario

    @property
    def place(self) -> str:
        """The place in the source that the draw belongs to."""
        return self.draw.place

    def levels(self, steps: int) -> Sequence[float]:
        """Numbers in [0, 1] that a grid visits."""
        from ..evaluate.dependencies import draws_in

        options = self.draw.call.options
        if any(True for _, v in options for _ in draws_in(v, self.scenario.values)):
            return [(step + 0.5) / steps for step in range(steps)]
        built = build(self.draw.call, self.scenario.fixed, single=True)
        with built.guarded:
            levels = [float(level) for level in built.kind.levels(steps)]
        if not levels or not all(0.0 <= level <= 1.0 for level in levels):
            raise wrong_result(built.entry, built.call.span, "gave no levels within [0, 1]")
        return levels


def drawn_values(scenario: IndexedScenario) -> tuple[DrawnPlace, ...]:
    """All draws made once for each scene, in the order of the scenario."""
    places = {draw.place: draw for draw in scenario.draws() if draw.per == "scene"}
    return tuple(DrawnPlace(draw, scenario) for draw in places.values())


def _check_points(
    points: NDArray[np.float64], sampler: KindInstance, count: int, dimensions: int
) -> None:
    if points.shape != (count, dimensions) or not ((points >= 0) & (points <= 1)).all():
        raise wrong_result(
            sampler.entry,
            sampler.call.span,
            f"gave points of shape {points.shape} or beyond [0, 1]",
        )
