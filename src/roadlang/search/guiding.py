"""Guided sampling: a pilot learns where the requirements hold; every scene then draws from there.

The pilot depends on scenario and seed alone, and a scene on the pilot and its own number, so that
neither the number of scenes nor that of workers changes any of them.
"""

from __future__ import annotations

import operator
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import Floats, read_only
from ..ir.batch import BatchRandom
from ..judging.acceptance import Acceptance, Measurements
from ..plugins.guard import wrong_result
from ..plugins.results import real_numbers
from .accepted import Accepted
from .attempts import accepted_attempts
from .effort import attempts_of
from .rejection_report import RejectionStats
from .surrogate import Surrogate

FIRST = 64
"""Candidates of the pilot that are drawn evenly."""
ROUND = 16
"""Candidates of each of its further rounds."""
ENOUGH = 36
"""Accepted candidates after which the pilot ends."""
LEADERS = 24
"""Candidates that others are proposed near to, until enough hold."""
PROPOSALS = 256
"""Proposals that are guessed at a time: guesses cost no candidates."""
TURNS, TURNS_WHERE_RARE = 3, 12
"""How often more are made, evenly but for the last time, before the likeliest is taken."""
LIKELY, LIKELY_WHERE_RARE = 0.3, 0.08
RARE = 0.004
"""Guessed acceptance below which more proposals are made, and bolder ones taken."""
STEERED = 64
"""Attempts of a scene that are proposed. The next are drawn evenly: a surrogate that guessed wrong
so often is of no use, and a guess costs more than a candidate."""
HOPELESS = 1e-6
"""Guessed chance below which no proposal is worth a guess: nothing that was tried holds."""
_PILOT = -1
_PLACE = "sample/guided"


@dataclass(frozen=True)
class Pilot:
    """`names` of the steered coordinates (d); `known` (n, d): where to draw near, empty where
    drawing evenly does as well."""

    names: tuple[str, ...]
    known: Floats
    surrogate: Surrogate | None
    stats: RejectionStats

    @cached_property
    def is_rare(self) -> bool:
        """Whether the surrogate guesses that only few even draws hold."""
        assert self.surrogate is not None
        even = np.random.Generator(np.random.Philox(key=0)).random((2048, len(self.names)))
        return float(self.surrogate.chance(even).mean()) < RARE

    def choose(self, sampler: KindInstance, random: BatchRandom) -> Floats:
        """(1, d) the first proposal that is likely to hold, even draws before steered ones; if none
        is, the most likely of all."""
        assert self.surrogate is not None
        dimensions = len(self.names)
        width = _numbers(sampler, dimensions)
        turns = TURNS_WHERE_RARE if self.is_rare else TURNS
        bar = LIKELY_WHERE_RARE if self.is_rare else LIKELY
        best, greatest = np.empty((1, dimensions)), -1.0
        for turn in range(turns):
            uniform = random.uniform(PROPOSALS * width, turn).reshape(PROPOSALS, width)
            steered = turn == turns - 1
            even = uniform[:, -dimensions:]
            proposed = _steered(sampler, self.known, uniform) if steered else even
            chance = self.surrogate.chance(proposed)
            if (chance >= bar).any():
                first = int((chance >= bar).argmax())
                return np.asarray(proposed[first : first + 1])
            if chance.max() > greatest:
                greatest = float(chance.max())
                best = proposed[chance.argmax()][None]
        return best

    def best_chance(self, sampler: KindInstance, random: BatchRandom) -> float:
        """The greatest guessed chance among proposals that are steered, and as many even draws."""
        assert self.surrogate is not None
        dimensions = len(self.names)
        width = _numbers(sampler, dimensions)
        uniform = random.uniform(PROPOSALS * width).reshape(PROPOSALS, width)
        steered = _steered(sampler, self.known, uniform)
        even = random.uniform(PROPOSALS * dimensions, 1).reshape(PROPOSALS, dimensions)
        return float(self.surrogate.chance(np.concatenate([steered, even])).max())

    def round(self, sampler: KindInstance, random: BatchRandom) -> Floats:
        """(ROUND, d) the likeliest of many proposals, for the pilot to measure."""
        assert self.surrogate is not None
        width = _numbers(sampler, len(self.names))
        uniform = random.uniform(PROPOSALS * width).reshape(-1, width)
        proposed = _steered(sampler, self.known, uniform)
        chance = self.surrogate.chance(proposed).reshape(ROUND, -1)
        groups = proposed.reshape(ROUND, -1, len(self.names))
        return np.asarray(groups[np.arange(ROUND), chance.argmax(axis=1)])


def _numbers(sampler: KindInstance, dimensions: int) -> int:
    with sampler.guarded:
        count = operator.index(sampler.kind.numbers(dimensions))
    if count < dimensions:
        fault = f"takes {count} random numbers for {dimensions} coordinates"
        raise wrong_result(sampler.entry, sampler.call.span, fault)
    return count


def _steered(sampler: KindInstance, known: Floats, uniform: Floats) -> Floats:
    """(V, d) proposals of the sampler. Raises RL474 where they are no points of the unit cube."""
    with sampler.guarded:
        result = sampler.kind.steer(read_only(known), read_only(uniform))
    proposed = real_numbers(result, "proposals", sampler.entry, sampler.call.span)
    expected = (len(uniform), known.shape[1])
    if proposed.shape != expected or not ((proposed >= 0.0) & (proposed < 1.0)).all():
        fault = f"gave proposals of shape {proposed.shape}, not {expected}, or beyond [0, 1)"
        raise wrong_result(sampler.entry, sampler.call.span, fault)
    return proposed


def guided_attempts(
    acceptance: Acceptance, sampler: KindInstance, seed: int, scenes: Sequence[int]
) -> tuple[list[Accepted], RejectionStats]:
    """The first accepted attempt of each scene, each searched for separately."""
    pilot = acceptance.scenario.once(("pilot", seed), lambda: run_pilot(acceptance, sampler, seed))
    stats = RejectionStats.empty(len(acceptance.requirements))
    if 0 in scenes:
        stats.add(pilot.stats)
    steered = STEERED if len(pilot.known) else 0
    searched = [first_accepted(acceptance, sampler, pilot, seed, s, stats, steered) for s in scenes]
    found = {accepted.scene: accepted for accepted in searched if accepted is not None}
    others = [scene for scene in scenes if scene not in found]
    even, counts = accepted_attempts(acceptance, sampler, seed, others, steered)
    stats.add(counts)
    found |= {accepted.scene: accepted for accepted in even}
    return [found[scene] for scene in scenes if scene in found], stats


def run_pilot(acceptance: Acceptance, sampler: KindInstance, seed: int) -> Pilot:
    """Learn where the requirements hold: candidates drawn evenly first, then rounds of those that a
    surrogate of the robustness takes for the likeliest, until enough of them hold."""
    stats = RejectionStats.empty(len(acceptance.requirements))
    record = DrawRecord()
    measured = acceptance.measure(_candidates(acceptance, seed, _PILOT, 0, FIRST, record=record))
    _count(stats, measured)
    names = tuple(record.coordinates)
    points = np.stack([*record.coordinates.values(), np.empty(FIRST)], axis=1)[:, :-1]
    scale = _scale(measured.rho)
    values = _scaled(measured.rho, scale)
    holds = np.asarray(measured.satisfied.all(axis=0))
    pilot = Pilot(names, np.empty((0, len(names))), None, stats)
    if not names or holds.sum() >= FIRST // 3:
        return pilot
    while True:
        surrogate = Surrogate.fit(
            points, values, None if pilot.surrogate is None else pilot.surrogate.lengths
        )
        pilot = Pilot(names, _leaders(points, values, holds), surrogate, stats)
        random = _candidates(acceptance, seed, _PILOT, len(points), 1).random(_PLACE)
        if holds.sum() >= ENOUGH or len(points) >= sampler.kind.pilot_size():
            hopeless = not holds.any() and pilot.best_chance(sampler, random) < HOPELESS
            return replace(pilot, known=pilot.known[:0]) if hopeless else pilot
        proposed = pilot.round(sampler, random)
        coordinates = dict(zip(names, proposed.T, strict=True))
        candidates = _candidates(acceptance, seed, _PILOT, len(points), ROUND, coordinates)
        measured = acceptance.measure(candidates)
        _count(stats, measured)
        points = np.concatenate([points, proposed])
        values = np.concatenate([values, _scaled(measured.rho, scale)])
        holds = np.concatenate([holds, measured.satisfied.all(axis=0)])


def _leaders(points: Floats, values: Floats, holds: NDArray[np.bool_]) -> Floats:
    """All points that hold, or the best where those are too few."""
    if holds.sum() >= LEADERS:
        return np.asarray(points[holds])
    score = np.minimum(values, 0.0).sum(axis=1)
    return np.asarray(points[np.argsort(-score, kind="stable")[:LEADERS]])


def first_accepted(
    acceptance: Acceptance,
    sampler: KindInstance,
    pilot: Pilot,
    seed: int,
    scene: int,
    stats: RejectionStats,
    attempts: int,
) -> Accepted | None:
    """The first accepted of the first attempts of a scene, which the pilot proposes."""
    for attempt in range(min(attempts, attempts_of(sampler, acceptance))):
        random = _candidates(acceptance, seed, scene, attempt, 1).random(_PLACE)
        proposed = pilot.choose(sampler, random)
        coordinates = dict(zip(pilot.names, proposed.T, strict=True))
        candidates = _candidates(acceptance, seed, scene, attempt, 1, coordinates)
        judged = acceptance.judge(candidates)
        stats.count(judged, np.ones(1, dtype=bool))
        if judged.accepted[0]:
            return Accepted(scene, scene, attempt, candidates.coordinates)
    return None


def _candidates(
    acceptance: Acceptance,
    seed: int,
    scene: int,
    start: int,
    count: int,
    values: Mapping[str, Floats] | None = None,
    record: DrawRecord | None = None,
) -> CandidateBatch:
    attempts = np.arange(start, start + count)
    return CandidateBatch(
        acceptance.scenario, seed, np.full(count, scene), attempts, values, record
    )


def _scale(rho: Floats) -> Floats:
    """(R, 1) the usual size of a violation of each requirement: units then do not matter."""
    wrong = np.where(np.isfinite(rho) & (rho < 0.0), -rho, 0.0)
    number = np.maximum((wrong > 0.0).sum(axis=1), 1)
    size = wrong.sum(axis=1) / number
    return np.where(size > 0.0, size, 1.0)[:, None]


def _scaled(rho: Floats, scale: Floats) -> Floats:
    """(V, R) robustness in usual violations, cut off where only the sign still matters."""
    return np.asarray(np.clip(np.nan_to_num(rho, posinf=1.0, neginf=-9.0) / scale, -3.0, 1.0)).T


def _count(stats: RejectionStats, measured: Measurements) -> None:
    """The pilot measures every requirement; the first that fails counts as what rejected."""
    rho, fails = measured.rho, ~measured.satisfied
    stats.candidates += rho.shape[1]
    for index in range(rho.shape[0]):
        before = fails[:index].any(axis=0)
        stats.tried[index] += int((~before).sum())
        stats.rejected[index] += int((fails[index] & ~before).sum())
        finite = rho[index][np.isfinite(rho[index])]
        stats.best[index] = max(stats.best[index], float(finite.max(initial=-np.inf)))
