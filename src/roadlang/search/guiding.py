"""Guided sampling: a pilot learns where the requirements hold; every scene then draws from there.

The pilot climbs by levels of robustness: the better third of its points stays, and others are
proposed near to those until the level is full again (subset simulation: Au and Beck, Estimation of
small failure probabilities in high dimensions by subset simulation, 2001). Regions that lie apart
have levels of their own, so that none crowds out another.

The pilot depends on scenario and seed alone, and a scene on the pilot and its own number, so that
neither the number of scenes nor that of workers changes any of them.
"""

from __future__ import annotations

import operator
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import Floats, read_only
from ..geometry.numbers.clusters import FEWEST, clusters, distances
from ..ir.batch import BatchRandom
from ..judging.acceptance import Acceptance, Measurements
from ..plugins.guard import wrong_result
from ..plugins.results import real_numbers
from .accepted import Accepted
from .effort import quicker_share
from .rejection_report import RejectionStats
from .rejection_sampling import accepted_attempts

FIRST = 320
"""Candidates of the pilot that are drawn evenly."""
ROUND = 64
"""Candidates that are proposed at a time."""
KEPT = 0.35
"""Share of the points of a region that a level keeps."""
POPULATION, FULL = 192, 0.75
"""Points that a level is filled up to; the share of its part that every region must have."""
ENOUGH, SLIGHT = 128, 3
"""Points that hold after which the pilot ends, if no region has less than a third of its part."""
ROUNDS = 5
"""Rounds after which a level ends, full or not."""
PATIENCE, GAIN = 8, 0.9
"""Levels that gain less than a tenth of what is missing, after which a pilot that has found nothing
ends."""
MOST_EVEN, TELLING = 960, 4
"""Even draws after which it is decided whether to learn; those that must hold to do without."""
LATE = 3
"""Levels that a pilot goes on for where enough points hold, but too few in some region."""
MOST_KNOWN = 256
"""Points that scenes are drawn near to."""
STEERED = 128
"""Attempts of a scene that are proposed. The next are drawn evenly: a pilot that is of no use so
often will not be of any."""
_PILOT = -1
_PLACE = "sample/guided"


@dataclass(frozen=True)
class Pilot:
    """`names` of the steered coordinates (d); `known` (n, d): where to draw near, empty where
    drawing evenly does as well. `share`: the guessed share of even draws that hold."""

    names: tuple[str, ...]
    known: Floats
    stats: RejectionStats
    share: float

    def propose(self, sampler: KindInstance, random: BatchRandom) -> Mapping[str, Floats]:
        """A proposal for each of the candidates that `random` is for, by name."""
        return _by_name(self.names, _steered(sampler, self.known, random))


def guided_attempts(
    acceptance: Acceptance, sampler: KindInstance, seed: int, scenes: Sequence[int]
) -> tuple[list[Accepted], RejectionStats]:
    """The first accepted attempt of each scene, each searched for separately."""
    pilot = acceptance.scenario.once(("pilot", seed), lambda: run_pilot(acceptance, sampler, seed))
    stats = RejectionStats.empty(len(acceptance.requirements))
    if 0 in scenes:
        stats.add(pilot.stats)
    stats.even_share = pilot.share if len(pilot.known) else None
    if not len(pilot.known):
        even, counts = accepted_attempts(acceptance, sampler, seed, scenes)
        stats.add(counts)
        return even, stats
    crowded: dict[int, int] = {}
    steered, counts = accepted_attempts(
        acceptance,
        sampler,
        seed,
        scenes,
        attempts=range(STEERED),
        propose=lambda candidates: pilot.propose(sampler, candidates.random(_PLACE)),
        crowded=crowded,
    )
    stats.add(counts)
    found = {accepted.scene: accepted for accepted in steered}
    others = [scene for scene in scenes if scene not in found]
    even, counts = accepted_attempts(
        acceptance, sampler, seed, others, attempts=range(STEERED, 1 << 62), crowded=crowded
    )
    stats.add(counts)
    found |= {accepted.scene: accepted for accepted in even}
    return [found[scene] for scene in scenes if scene in found], stats


def run_pilot(acceptance: Acceptance, sampler: KindInstance, seed: int) -> Pilot:
    """Learn where the requirements hold: even draws first, then level after level."""
    with sampler.guarded:
        most, falls_back = int(sampler.kind.pilot_size()), bool(sampler.kind.falls_back())
    climb = _Climb(acceptance, sampler, seed, most)
    if not climb.names or (falls_back and climb.is_quicker_evenly(quicker_share(acceptance))):
        share = float(climb.holds.mean())
        return Pilot(climb.names, climb.points[:0], climb.stats, share)
    share, idle, late, best = 1.0, 0, 0, climb.scores.max()
    while climb.measured < most and idle < PATIENCE and late < LATE:
        share *= climb.level()
        if climb.is_settled():
            break
        late += int(climb.holds.sum() >= ENOUGH)
        gained = climb.scores.max() > GAIN * best or climb.holds.any()
        idle, best = 0 if gained else idle + 1, max(best, climb.scores.max())
    known = climb.points[climb.holds]
    share *= len(known) / len(climb.points)
    return Pilot(climb.names, known[_some(len(known), MOST_KNOWN)], climb.stats, share)


class _Climb:
    """The points of a pilot that are above its level."""

    def __init__(self, acceptance: Acceptance, sampler: KindInstance, seed: int, most: int) -> None:
        self.acceptance, self.sampler, self.seed, self.most = acceptance, sampler, seed, most
        self.stats = RejectionStats.empty(len(acceptance.requirements))
        self.measured = 0
        found = self._even(min(FIRST, most))
        self.scale = _scale(found.rho)
        self.scores, self.holds = self._scored(found)

    def _even(self, count: int) -> Measurements:
        """Draw more candidates evenly."""
        record = DrawRecord()
        candidates = self._candidates(self.measured, count, record=record)
        found = self.acceptance.measure(candidates)
        drawn = record.named_coordinates()
        self.names = tuple(drawn)
        columns = [*drawn.values(), np.empty(count)]
        points = np.stack(columns, axis=1)[:, :-1]
        self.points: Floats = np.concatenate([self.points, points]) if self.measured else points
        self.measured += count
        return found

    def is_quicker_evenly(self, share: float) -> bool:
        """Whether enough even draws satisfy the requirements that a scene is found sooner without
        learning; if the first draws do not tell, more are made."""
        while self.measured < min(MOST_EVEN, self.most):
            seen = int(self.holds.sum())
            if seen >= TELLING or (seen == 0 and self.measured > FIRST):
                break
            found = self._even(min(FIRST, self.most - self.measured))
            scores, holds = self._scored(found)
            self.scores = np.concatenate([self.scores, scores])
            self.holds = np.concatenate([self.holds, holds])
        return int(self.holds.sum()) >= max(TELLING, share * self.measured)

    def level(self) -> float:
        """Keep the better points of each region, and fill up with proposals that are as good as the
        worst that was kept near to them. Returns the share of the points that was kept."""
        regions = clusters(self.points)
        bars = np.array([self._bar(regions == region) for region in range(regions.max() + 1)])
        kept = self.scores >= bars[regions]
        for region in range(bars.size):
            crowd = np.flatnonzero(kept & self.holds & (regions == region))
            kept[crowd] = False
            kept[crowd[_some(len(crowd), POPULATION // bars.size + FEWEST)]] = True
        share = float(kept.mean())
        self._keep(kept)
        known, regions = self.points, regions[kept]
        sizes = np.bincount(regions)
        for _ in range(ROUNDS):
            if sizes.min() >= FULL * POPULATION / sizes.size or self.measured >= self.most:
                break
            count = min(ROUND, self.most - self.measured)
            random = self._candidates(self.measured, count).random(_PLACE)
            points = _steered(self.sampler, known, random)
            coordinates = _by_name(self.names, points)
            found = self.acceptance.measure(self._candidates(self.measured, count, coordinates))
            self.measured += count
            scores, holds = self._scored(found)
            nearest = distances(np.concatenate([known, points]))[len(known) :, : len(known)]
            region = regions[nearest.argmin(axis=1)]
            good = scores >= bars[region]
            sizes += np.bincount(region[good], minlength=sizes.size)
            self.points = np.concatenate([self.points, points[good]])
            self.scores = np.concatenate([self.scores, scores[good]])
            self.holds = np.concatenate([self.holds, holds[good]])
        return share

    def _bar(self, members: NDArray[np.bool_]) -> float:
        """The least score that is kept of the points of a region."""
        scores = np.sort(self.scores[members])[::-1]
        return float(scores[min(len(scores) - 1, max(FEWEST, int(KEPT * len(scores))) - 1)])

    def is_settled(self) -> bool:
        """Whether enough points hold, and not too few of them in any region."""
        if self.holds.sum() < ENOUGH:
            return False
        regions = clusters(self.points)
        holding = np.bincount(regions[self.holds], minlength=int(regions.max()) + 1)
        return int(holding.min()) * SLIGHT * holding.size >= ENOUGH

    def _keep(self, rows: NDArray[np.bool_]) -> None:
        self.points, self.scores = self.points[rows], self.scores[rows]
        self.holds = self.holds[rows]

    def _scored(self, found: Measurements) -> tuple[Floats, NDArray[np.bool_]]:
        """How far each candidate is from holding, in usual violations: 0 for those that hold."""
        _count(self.stats, found)
        holds = np.asarray(found.satisfied.all(axis=0))
        scaled = np.nan_to_num(found.rho, posinf=0.0, neginf=-9.0) / self.scale
        missing = np.where(found.satisfied, 0.0, np.clip(scaled, -9.0, 0.0)).sum(axis=0)
        return np.where(holds, 0.0, np.minimum(missing, -1e-12)), holds

    def _candidates(
        self,
        start: int,
        count: int,
        values: Mapping[str, Floats] | None = None,
        record: DrawRecord | None = None,
    ) -> CandidateBatch:
        attempts, scenes = np.arange(start, start + count), np.full(count, _PILOT)
        return CandidateBatch(self.acceptance.scenario, self.seed, scenes, attempts, values, record)


def _some(count: int, most: int) -> NDArray[np.intp]:
    """Indices below `count`, evenly spread, at most as many as given."""
    return np.arange(count) if count <= most else np.arange(most) * count // most


def _by_name(names: Sequence[str], points: Floats) -> Mapping[str, Floats]:
    return dict(zip(names, points.T, strict=True))


def _steered(sampler: KindInstance, known: Floats, random: BatchRandom) -> Floats:
    """(V, d) proposals of the sampler. Raises RL474 where they are no points of the unit cube."""
    dimensions = known.shape[1]
    with sampler.guarded:
        width = operator.index(sampler.kind.numbers(dimensions))
    if width < dimensions:
        fault = f"takes {width} random numbers for {dimensions} coordinates"
        raise wrong_result(sampler.entry, sampler.call.span, fault)
    uniform = random.uniform(width)
    with sampler.guarded:
        result = sampler.kind.steer(read_only(known), read_only(uniform))
    proposed = real_numbers(result, "proposals", sampler.entry, sampler.call.span)
    expected = (len(uniform), dimensions)
    if proposed.shape != expected or not ((proposed >= 0.0) & (proposed < 1.0)).all():
        fault = f"gave proposals of shape {proposed.shape}, not {expected}, or beyond [0, 1)"
        raise wrong_result(sampler.entry, sampler.call.span, fault)
    return proposed


def _scale(rho: Floats) -> Floats:
    """(R, 1) the usual size of a violation of each requirement: units then do not matter."""
    wrong = np.where(np.isfinite(rho) & (rho < 0.0), -rho, 0.0)
    number = np.maximum((wrong > 0.0).sum(axis=1), 1)
    size = wrong.sum(axis=1) / number
    return np.where(size > 0.0, size, 1.0)[:, None]


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
