"""What signals reach somewhere on a road whatever is drawn: it refutes some requirements.

Bounds of a signal hold at every station. That `perturb with sine { amplitude: 20m..30m }` moves a
road by 20 m or more is true of one station, which is enough to refute `always (deviation < 10m)`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..geometry import CurveFrame
from ..geometry.numbers.differences import station_gaps
from ..ir.road_bounds import RoadBounds
from ..ir.scenario import ScenarioRoad
from ..ir.values import Condition, Entity, PassCall
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Perturber, Signal, implements
from ..plugins.stated_bounds import OptionRange, corners
from ..stl.evaluate.static_truth import fails_at_one_sample
from ..world.roads.roads import road_root
from .variable_bounds import ROUNDING, ScenarioBounds


def refuting_values(condition: Condition, candidates: CandidateBatch) -> tuple[str, ...]:
    """The signals, with the values that they reach somewhere, that no draw can satisfy a formula
    with; in words, none where it may be satisfied. `candidates` are any of the scenario."""
    if condition.domain != "road":
        return ()
    bounds, found = _ReachedBounds(candidates), []
    for binding in condition.signals:
        least = bounds.reached(binding.call)
        if least <= 0.0:
            continue
        variables = bounds.variables(condition)
        narrowed = {**variables, binding.variable: (least, variables[binding.variable][1])}
        if fails_at_one_sample(condition.formula, narrowed):
            moved = "; ".join(bounds.causes(binding.call))
            found.append(f"`{binding.variable}` is {least:.4g}m or more somewhere: {moved}")
    return tuple(found)


class _ReachedBounds(ScenarioBounds):
    """Bounds for every candidate, with what passes on roads without draws reach."""

    def __init__(self, candidates: CandidateBatch) -> None:
        super().__init__(candidates.scenario)
        self._candidates = candidates

    def reached(self, call: PassCall) -> float:
        """What a signal reaches at some station of its road; 0 where that is not known."""
        entry, kind = self.scenario.kind(call)
        assert issubclass(kind, Signal)
        options = self.options(call, kind) if implements(kind, "reached") else None
        if options is None or not all(isinstance(v, RoadBounds) for v in options.values()):
            return 0.0
        with plugin_guard(entry, call.span):
            return float(kind.reached(options)) * (1.0 - ROUNDING)

    def road(self, entity: Entity) -> RoadBounds | str:
        """The bounds of a road, with what its passes reach."""
        bounds = super().road(entity)
        if not isinstance(bounds, RoadBounds) or entity.role != "road":
            return bounds
        calls = self._passes(entity.name)
        return replace(bounds, reached={call.place: self._reached(call, entity) for call in calls})

    def causes(self, call: PassCall) -> Iterator[str]:
        """The passes that make a signal reach what it does, as they are written."""
        named = [value for value in call.options.values() if isinstance(value, Entity)]
        for road in named:
            for one in self._passes(road.name):
                if self._reached(one, road) > 0.0 and one.span is not None:
                    text = " ".join(one.span.text.split())
                    yield f"`{text}` of `{road.name}` (line {one.span.line})"

    def _passes(self, name: str) -> Iterator[PassCall]:
        for link in self.scenario.chain(self.scenario.roads[name]):
            if isinstance(link, ScenarioRoad):
                yield from (call for call in link.passes if call.verb == "perturb")

    def _reached(self, call: PassCall, road: Entity) -> float:
        """Meters that a pass moves a road by somewhere, whatever is drawn."""
        entry, kind = self.scenario.kind(call)
        assert issubclass(kind, Perturber)
        frame = self._frame(road.name)
        if call.common or frame is None or not implements(kind, "displacement_reached"):
            return 0.0
        combinations = _corners_on_either_side_of_0(kind, self.values.options(call))
        gap = float(station_gaps(frame.stations, frame.period).max())
        found = []
        for fields in combinations:
            with plugin_guard(entry, call.span):
                instance = kind(**fields)
                found.append(instance.displacement_reached(frame.curve.length, frame.closed, gap))
        return max(0.0, float(np.min(found, initial=math.inf))) if found else 0.0

    def _frame(self, name: str) -> CurveFrame | None:
        """The frame of a road before it is perturbed; None where a draw has a say in it."""
        scenario = self.scenario
        links = list(scenario.chain(scenario.roads[name]))
        if scenario.is_varying(name) or any(map(scenario.is_joined, links)):
            return None
        return road_root(name, self._candidates).frame


def _corners_on_either_side_of_0(
    kind: type[Perturber], options: dict[str, Any]
) -> list[dict[str, Any]]:
    """As `corners`, but that a range with both signs counts as two; none where one is unknown."""
    parts: list[dict[str, Any]] = [{}]
    for name, value in options.items():
        ends = [value]
        if isinstance(value, OptionRange) and value.low < 0.0 < value.high:
            ends = [OptionRange(value.low, 0.0), OptionRange(0.0, value.high)]
        parts = [{**part, name: end} for part in parts for end in ends]
    found = [corners(kind, part) for part in parts]
    known = [each for each in found if each is not None]
    return [fields for each in known for fields in each] if len(known) == len(found) else []
