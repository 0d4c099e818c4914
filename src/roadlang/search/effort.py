"""How many candidates are tried before a scene is given up, where the file does not say it.

The number follows from the work of a candidate, not from the clock, so that it is the same on every
machine.
"""

from __future__ import annotations

import operator

import numpy as np

from ..evaluate.candidates import fixed_candidate
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import KindInstance
from ..ir.scenario import ScenarioImage
from ..judging.acceptance import Acceptance
from ..world.networks.networks import network_root
from ..world.roads.roads import road_root

BATCH = 512
"""Candidates judged at once: a signal of 500 stations then fits the second cache."""
MOST_LATER = 8 * BATCH
"""The most of those that are judged at once where many are known to be needed: as many as
fit the cache like `BATCH`, for a batch takes a while however few candidates it has."""
NUMBERS_AT_ONCE = BATCH * 2_001
"""Candidates times stations: more would take gigabytes of memory."""
MOST, FEWEST = 10_000, 100
BUDGET = 5e8
"""Units of work (a displacement at one station), about ten nanoseconds each."""
JUDGING = 300
"""Units that any candidate takes."""
GUIDED_CANDIDATES = 40
"""Candidates a scene that guiding takes, of 30 scenes that share a pilot; and the units of work, a
scene, of learning and proposing:"""
GUIDING = 1.3e5
UNBATCHED = 1_000
"""Attempts where the stations differ, so that candidates cannot be judged together."""
WITH_PICTURES = 20
"""Attempts where every candidate is extracted from a picture of its own: seconds each."""

CROWDED, FEWEST_CROWDED = 40, 4
"""Attempts of a scene that fail only because something finds no room, at the last of which it is
given up: each has been arranged many times. Counted attempt by attempt, so that the size of batches
does not decide it. So many where at most these copies are placed; of more copies fewer attempts,
for each takes longer, and all are more alike:"""
CROWD = 400


def count_or_none(value: object, name: str) -> int | None:
    """A count or None. Raises `TypeError` for anything else, `ValueError` below 0."""
    count = None if value is None else operator.index(value)  # type: ignore[arg-type]
    if count is not None and count < 0:
        raise ValueError(f"its {name} is {count}")
    return count


def attempts_of(sampler: KindInstance, acceptance: Acceptance) -> int:
    """The sampler's own limit, or as many as are done in about five seconds."""
    with sampler.guarded:
        limit = count_or_none(sampler.kind.limit(), "limit")
    return limit if limit is not None else default_attempts(acceptance)


def crowded_attempts(scenario: IndexedScenario) -> int:
    """After how many attempts that fail for want of room a scene is given up."""
    counts = [
        scenario.value_bounds.of(actor.options["count"])[1]
        for actor in scenario.actors.values()
        if "count" in actor.options
    ]
    copies = float(np.clip(sum(counts), CROWD, 1e9))
    return max(FEWEST_CROWDED, int(CROWDED * CROWD / copies))


def batch_size(acceptance: Acceptance) -> int:
    """How many candidates are judged at once; what is accepted does not depend on it."""
    if acceptance.has_varying_stations:
        return 1
    return max(1, min(BATCH, NUMBERS_AT_ONCE // _stations_of(acceptance)))


def later_batch_size(acceptance: Acceptance) -> int:
    """The same after a first batch, in which scenes were left that need more."""
    if acceptance.has_varying_stations:
        return 1
    size = batch_size(acceptance)
    return max(size, min(MOST_LATER, size * 500 // _stations_of(acceptance)))


def default_attempts(acceptance: Acceptance) -> int:
    """A guess from what the requirements look at."""
    scenario = acceptance.scenario
    names = {name for requirement in acceptance.requirements for name in requirement.names}
    if any(_has_drawn_picture(name, scenario) for name in names):
        return WITH_PICTURES
    if acceptance.has_varying_stations:
        return UNBATCHED
    return int(np.clip(BUDGET / max(_work(acceptance), 1.0), FEWEST, MOST))


def quicker_share(acceptance: Acceptance) -> float:
    """The share of even draws that hold from which on a scene is found sooner by even draws than
    by a pilot and what it proposes, which have work of their own."""
    of_guiding = GUIDING / (JUDGING + _work(acceptance))
    return 1.0 / (GUIDED_CANDIDATES + of_guiding)


def _work(acceptance: Acceptance) -> float:
    """Units of work that the requirements of a candidate are."""
    return sum(
        requirement.cost * _stations(requirement.names, acceptance.scenario)
        for requirement in acceptance.requirements
        if not requirement.last
    )


def _has_drawn_picture(name: str, scenario: IndexedScenario) -> bool:
    links = (
        link
        for link in scenario.ancestry(scenario.declaration(name))
        if isinstance(link, ScenarioImage)
    )
    return any(scenario.is_varying(link.name) for link in links)


def _stations_of(acceptance: Acceptance) -> int:
    names = frozenset(name for r in acceptance.requirements for name in r.names)
    return _stations(names, acceptance.scenario)


def _stations(names: frozenset[str], scenario: IndexedScenario) -> int:
    """Of all the roads that are looked at."""
    return scenario.once(("stations of", names), lambda: _counted(names, scenario))


def _counted(names: frozenset[str], scenario: IndexedScenario) -> int:
    fixed = fixed_candidate(scenario)
    count = 1
    for name in names:
        if name in scenario.roads:
            count = max(count, len(road_root(name, fixed).frame.stations))
        elif name in scenario.networks:
            root = network_root(scenario.networks[name], fixed)
            count = max(count, sum(len(root.frame(edge.id).stations) for edge in root.edges))
    return count
