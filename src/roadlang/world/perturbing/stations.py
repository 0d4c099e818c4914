"""Where roads are sampled: at stations, arc lengths of their root road, evenly spaced.

All that derives from one root shares its stations, so that it can be compared point by point. They
are a meter apart, closer on short roads, farther apart on long ones; closer also where a statement
asks for it (`station_spacing`) or where a `perturb` has waves or bumps that they would not show.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.candidates import fixed_candidate
from ...evaluate.evaluation import evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...evaluate.kind_instance import scalar
from ...geometry import Curve
from ...ir.scenario import ScenarioImage, ScenarioNetwork, ScenarioRoad
from ...ir.values import PassCall
from .shortest_features import shortest_feature, states_feature

Root: TypeAlias = ScenarioRoad | ScenarioNetwork

SPACING = 1.0
FEWEST, DEFAULT_MOST = 51, 2001
"""Stations of a road, where no statement and no perturbation asks for more."""
MOST = 20_001
STATIONS_PER_FEATURE = 8
"""Samples of a wave for which its curvature is within 5 % of the true one."""


def default_stations(curve: Curve) -> NDArray[np.float64]:
    """(S,) even arc lengths of a road that nothing asks more of: a meter apart, closer on a short
    road, farther apart on a long one."""
    count = math.ceil(curve.length / SPACING) + 1
    return curve.stations(count=min(max(count, FEWEST), DEFAULT_MOST))


@dataclass(frozen=True)
class StationSpacing:
    """What sets the stations of the roads of one root: the finest `station_spacing` written, and
    the `perturb` passes of all that derives from it."""

    scenario: IndexedScenario
    root: Root
    written: tuple[float, Root] | None
    passes: tuple[PassCall, ...]

    def stations(self, curve: Curve) -> NDArray[np.float64]:
        """(S,) even arc lengths of a root road. Raises RL418 and RL419 where more than `MOST` would
        be needed."""
        count = len(default_stations(curve))
        if self.written is not None:
            count = self._written_count(curve, *self.written)
        for call in self.passes:
            feature = shortest_feature(call, self.scenario, curve.length, curve.closed)
            if feature is not None:
                count = max(count, self._count_for(feature, call, curve))
        return curve.stations(count=count)

    def _written_count(self, curve: Curve, spacing: float, owner: Root) -> int:
        count = max(math.ceil(curve.length / spacing - 1e-9) + 1, 4)
        if count > MOST:
            finest = _rounded_up(curve.length / (MOST - 1))
            raise DiagnosticError(
                diagnose(
                    Code.TOO_MANY_STATIONS,
                    owner.span,
                    road=self.root.name,
                    length=f"{curve.length:.6g}m",
                    spacing=f"{spacing:g}m",
                    count=f"{count:,}",
                    most=f"{MOST:,}",
                    help=(f"write `station_spacing: {finest:g}m`",),
                )
            )
        return count

    def _count_for(self, feature: float, call: PassCall, curve: Curve) -> int:
        gaps = curve.length * STATIONS_PER_FEATURE / feature
        if gaps > MOST - 1:
            shortest = _rounded_up(curve.length * STATIONS_PER_FEATURE / (MOST - 1))
            raise DiagnosticError(
                diagnose(
                    Code.PERTURBATION_TOO_SHORT,
                    call.span,
                    kind=call.kind.rpartition(".")[2],
                    feature=f"{feature:.3g}m",
                    road=self.root.name,
                    length=f"{curve.length:.6g}m",
                    help=(
                        f"a road has at most {MOST:,} stations; those of `{self.root.name}` show "
                        f"what is {shortest:g}m long or longer",
                    ),
                )
            )
        return math.ceil(gaps - 1e-9) + 1


def unknown_features(source: Root, scenario: IndexedScenario) -> tuple[PassCall, ...]:
    """The `perturb` passes of a road or network whose shortest feature only the draws tell."""
    return tuple(
        call
        for call in source.passes
        if call.verb == "perturb"
        and states_feature(call, scenario)
        and shortest_feature(call, scenario, 1.0, closed=False) is None
    )


def station_spacing(source: Root, scenario: IndexedScenario) -> StationSpacing:
    """That of the root of a road or network."""
    root = root_of(source, scenario)

    def find() -> StationSpacing:
        sources: list[Root] = [*scenario.networks.values(), *scenario.roads.values()]
        derived = [other for other in sources if root_of(other, scenario) is root]
        written = [
            (float(scalar(evaluate(value, fixed_candidate(scenario)))), other)
            for other in derived
            if (value := other.options.get("station_spacing")) is not None
        ]
        passes = [call for other in derived for call in other.passes if call.verb == "perturb"]
        finest = min(written, key=lambda item: item[0]) if written else None
        return StationSpacing(scenario, root, finest, tuple(passes))

    return scenario.once(("station spacing", root.name), find)


def root_of(source: Root, scenario: IndexedScenario) -> Root:
    """The road or network that a road or network derives from, through all statements."""
    links = [link for link in scenario.chain(source) if not isinstance(link, ScenarioImage)]
    return links[-1]


def _rounded_up(length: float) -> float:
    """To two digits: what a message asks for must be enough."""
    step = 10.0 ** (math.floor(math.log10(length)) - 1)
    return math.ceil(length / step - 1e-9) * step
