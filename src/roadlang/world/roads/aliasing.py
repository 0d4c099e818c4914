"""Perturbations that change faster than the stations show, of kinds that do not say how fast.

Such a pass is run again on the root road with seven times as many stations. Where it gives
something else at the same places, or between them something else than a straight line, what is
emitted is not what was meant: a wave of two stations may vanish altogether.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

import numpy as np

from ...diagnostics import DiagnosticError
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry import CurveFrame
from ...geometry.arrays import Floats
from ...ir.scenario import ScenarioNetwork
from ...ir.values import PassCall
from ..networks.networks import network_root
from ..perturbing.perturbation import displacement_by
from ..perturbing.root_roads import undisplaced_road
from ..perturbing.shortest_features import states_feature
from ..perturbing.stations import Root
from .roads import road_root

TOLERANCE = 0.15
"""Tolerance as a share of the displacement: a straight line between stations misses a wave of six
stations by this much."""
FINER = 7
"""A prime: waves of whole stations, and of halves and thirds, are not zero at all of these."""


def has_silent_passes(scenario: IndexedScenario) -> bool:
    """Whether any pass has a kind that does not say how fast it changes."""
    sources: tuple[Root, ...] = (*scenario.networks.values(), *scenario.roads.values())
    return any(
        call.verb == "perturb" and not states_feature(call, scenario)
        for source in sources
        for call in source.passes
    )


def aliasing_remarks(candidate: CandidateBatch) -> tuple[str, ...]:
    """Remarks on the passes of one candidate whose displacement the stations do not show."""
    scenario = candidate.scenario
    sources: tuple[Root, ...] = (*scenario.networks.values(), *scenario.roads.values())
    return tuple(
        f"`perturb with {call.kind}` changes faster than the stations of `{source.name}` show, or "
        "is not a function of arc length: set `station_spacing`, or let the kind state its "
        "`shortest_feature`"
        for source in sources
        for call in source.passes
        if call.verb == "perturb"
        and not states_feature(call, scenario)
        and any(_is_aliased(call, candidate, *root) for root in _roots(source, candidate))
    )


def _roots(source: Root, candidate: CandidateBatch) -> Iterator[tuple[int, CurveFrame]]:
    """The numbers and frames of the roads that a pass perturbs."""
    if not isinstance(source, ScenarioNetwork):
        yield 0, road_root(source.name, candidate).frame
        return
    root = network_root(source, candidate)
    for edge in root.edges:
        yield edge.id, root.frame(edge.id)


def _is_aliased(call: PassCall, candidate: CandidateBatch, element: int, frame: CurveFrame) -> bool:
    gaps = len(frame.stations) - (0 if frame.closed else 1)
    count = FINER * gaps + (0 if frame.closed else 1)
    fine = CurveFrame.of(frame.curve, frame.curve.stations(count=count))
    coarse, exact = None, None
    with suppress(DiagnosticError):  # a kind that has run before, but not with so many stations
        coarse = _displacement(call, candidate, element, frame)
        exact = _displacement(call, candidate, element, fine)
    if coarse is None or exact is None or coarse.ndim != exact.ndim:
        return False
    following = np.roll(coarse, -1, axis=1) if frame.closed else coarse[:, 1:]
    before = coarse[:, :gaps]
    missed = max(
        _greatest(exact[:, step : step + FINER * (gaps - 1) + 1 : FINER] - straight)
        for step in range(FINER)
        for straight in [before + (following - before) * (step / FINER)]
    )
    return missed > TOLERANCE * _greatest(exact) + 1e-9


def _displacement(
    call: PassCall, candidate: CandidateBatch, element: int, frame: CurveFrame
) -> Floats:
    road = undisplaced_road(call.place, call.place, frame, np.ones((1, 1)), 1.0)
    built = build(call, candidate, element)
    return displacement_by(built, road, candidate.random(call.place, element), candidate)


def _greatest(values: Floats) -> float:
    return float(np.abs(values).max(initial=0.0))
