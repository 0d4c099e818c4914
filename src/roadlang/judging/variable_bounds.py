"""Bounds of the variables of a formula: from draws, and from what kinds state of themselves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import build, evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import KindInstance
from ..geometry.arrays import Floats, flat
from ..ir.road_bounds import RoadBounds
from ..ir.scenario import ScenarioRoad
from ..ir.values import Condition, Entity, Measure, PassCall, Value
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.kinds import Kind, Signal, implements
from ..plugins.options import schema_of
from ..plugins.stated_bounds import corners
from ..plugins.value_bounds import ValueBounds
from ..stl.evaluate.interval_arithmetic import UNKNOWN, Bounds, hull
from ..world.perturbing.displacement_bound import displacement_bound
from ..world.signals import call_key

ROUNDING = 1e-9
"""How far a computed value may be beyond a bound, relative to it, or in its unit below 1"""


class VariableBounds:
    """Bounds of the variables of formulas. Subclasses say what is known of the draws."""

    scenario: IndexedScenario
    values: ValueBounds

    def variables(self, condition: Condition) -> dict[str, Bounds]:
        """Least and greatest value of each, (V,) or a number."""
        found = {binding.variable: self.signal(binding.call) for binding in condition.signals}
        for binding in condition.numbers:
            found[binding.variable] = self.values.of(binding.value)
        return found

    def signal(self, call: PassCall) -> Bounds:
        """What the kind of a road signal, or of a number of a road, states. Raises RL474."""
        entry, kind = self.scenario.kind(call)
        assert issubclass(kind, Signal)
        options = self.options(call, kind) if implements(kind, "range") else None
        combinations = None if options is None else corners(kind, options)
        if combinations is None:
            return UNKNOWN
        stated = []
        for fields in combinations:
            with plugin_guard(entry, call.span):
                ends = [flat(end) for end in kind.range(fields)]
            if len(ends) != 2 or not (self._fits(*ends) and (ends[0] <= ends[1]).all()):
                shown = " to ".join(str(end[:3]) for end in ends)
                raise wrong_result(entry, call.span, f"gave the range {shown}")
            stated.append((ends[0], ends[1]))
        low, high = hull(stated)
        # Values are computed with rounding, stated bounds without.
        return _farther(low, -ROUNDING), _farther(high, ROUNDING)

    def options(self, call: PassCall, kind: type[Kind]) -> dict[str, Any] | None:
        """All options of a signal by name, defaults included; None where geometry decides one."""
        options = {o.name: o.default for o in schema_of(kind) if not o.required}
        for name, value in call.options.items():
            if is_geometric(value, self.scenario):
                return None
            options[name] = self.road(value) if isinstance(value, Entity) else self.option(value)
        return options

    def road(self, entity: Entity) -> RoadBounds | str:
        """The bounds of a road or network by its passes; of other things the name."""
        if entity.role not in ("road", "network"):
            return entity.name
        links = list(self.scenario.chain(self.scenario.declaration(entity.name)))
        root = [link for link in links if isinstance(link, type(links[0]))][-1]
        bounds: dict[str, Any] = {}
        for link in links:
            for call in link.passes:
                if call.verb == "perturb":
                    # The passes of a network draw anew for each of its roads.
                    known = isinstance(link, ScenarioRoad)
                    bounds[call.place] = self.displacement(call) if known else math.inf
        return RoadBounds(entity.name, root.name, bounds)

    def option(self, value: Value) -> Any:
        """The value of an option, as `Signal.range` gets it."""
        raise NotImplementedError

    def displacement(self, call: PassCall) -> Floats:
        """(V, 1) or (1, 1) bounds of the displacement of a pass. Raises RL474 for what is none."""
        raise NotImplementedError

    @property
    def count(self) -> int:
        """How many candidates the bounds are for."""
        return 1

    def _fits(self, *ends: Floats) -> bool:
        return all(end.size in (1, self.count) for end in ends)


class CandidateBounds(VariableBounds):
    """Bounds for candidates whose draws are known."""

    def __init__(self, candidates: CandidateBatch) -> None:
        self.scenario = candidates.scenario
        self.candidates = candidates
        kind, named = self.scenario.kind, self.scenario.value_of
        self.values = ValueBounds(named, kind, self._known)

    def signal(self, call: PassCall) -> Bounds:
        """(V,) or (1,) bounds of a signal or number of a road, computed once for the candidates."""
        stated = super().signal
        return self.candidates.once(("bounds", call_key(call)), lambda: stated(call))

    def option(self, value: Value) -> Any:
        """A number, or a column (V, 1)."""
        return evaluate(value, self.candidates)

    def displacement(self, call: PassCall) -> Floats:
        """(V, 1) or (1, 1) bounds of the displacement of a pass. Raises RL474 for what is none."""
        return displacement_bound(build(call, self.candidates), self.count)[:, None]

    @property
    def count(self) -> int:
        """How many candidates the bounds are for."""
        return self.candidates.count

    def _known(self, value: Value) -> Bounds | None:
        if isinstance(value, Measure):
            return self.signal(value.call)
        if is_geometric(value, self.scenario):
            return None
        found = np.asarray(evaluate(value, self.candidates), dtype=float).reshape(-1)
        return found, found


class ScenarioBounds(VariableBounds):
    """Bounds for every candidate that the scenario has."""

    def __init__(self, scenario: IndexedScenario) -> None:
        self.scenario = scenario
        self.values = ValueBounds(scenario.value_of, scenario.kind, self._known)

    def option(self, value: Value) -> Any:
        """An `OptionRange`, also where the number is constant."""
        return self.values.option(value)

    def displacement(self, call: PassCall) -> Floats:
        """(1, 1) the greatest bound for any draw. Raises RL474 for what is none."""
        entry, kind = self.scenario.kind(call)
        combinations = corners(kind, self.values.options(call))
        greatest = np.full((1, 1), math.inf if combinations is None else 0.0)
        for fields in combinations or ():
            with plugin_guard(entry, call.span):
                instance = kind(**fields)
            bound = displacement_bound(KindInstance(instance, entry, call), 1)
            greatest = np.maximum(greatest, bound)
        return greatest

    def _known(self, value: Value) -> Bounds | None:
        return self.signal(value.call) if isinstance(value, Measure) else None


def is_geometric(value: Value, scenario: IndexedScenario) -> bool:
    """Whether a value depends on the geometry of roads."""
    return any(isinstance(item, Measure) for item in scenario.dependencies.contents(value))


def _farther(end: Any, share: float) -> Floats:
    """An end of a range, moved by a share of its size."""
    size = np.clip(np.abs(end), 1.0, np.finfo(float).max)
    return np.asarray(end + share * size)
