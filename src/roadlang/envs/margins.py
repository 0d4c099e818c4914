"""The robustness of expectations step by step, over many scenes at once."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import stl
from ..diagnostics import Code, DiagnosticError, diagnose
from ..geometry.arrays import Floats, Integers
from ..ir.scene import Scene, Verdict
from ..plugins.drive_signals import drive_signal_kind, named_entities
from ..plugins.finding import entry_of
from ..plugins.registry import Registry
from ..simulation.signals.conditions import Signal, term_values
from ..simulation.signals.samples import Samples
from ..simulation.signals.signals import SignalCall
from ..simulation.state.world import World
from ..stl.evaluate.graph_operations import OF_INFINITIES, ROBUST
from ..stl.evaluate.measured_robustness import measured_rho
from ..stl.formats.evaluation_json import evaluation_from_json
from ..stl.formula.evaluation_options import EvaluationOptions
from .rewards import MOST


@dataclass(frozen=True)
class _Form:
    """Scenes whose expectations differ in their numbers alone. `formula` is in normal form, except
    with weights, which belong to its operands as they are written."""

    rows: Integers
    formula: stl.Formula
    evaluation: EvaluationOptions
    signals: Mapping[str, SignalCall]
    numbers: Mapping[str, Floats]

    def values(self, samples: Samples) -> Floats:
        """(R,) robustness now."""
        known: dict[str, Floats] = dict(self.numbers)

        def value(name: str) -> Floats:
            if name not in known:
                known[name] = self.signals[name].values(samples)
            return known[name]

        if not self.evaluation.weights:
            return _robustness(self.formula, value, len(self.rows))
        now = {name: value(name)[:, None] for name in sorted(self.formula.variables)}
        rho = measured_rho(self.formula, np.zeros(1), now, self.evaluation)
        return np.broadcast_to(rho, len(self.rows))


class Margins:
    """The margin now of one expectation, for each scene of a world."""

    def __init__(self, name: str, world: World, registry: Registry) -> None:
        self.name = name
        members: dict[str, list[tuple[int, Mapping[str, Any]]]] = {}
        for row, scene in enumerate(world.scenes):
            call = _condition(name, scene)
            form = [call["formula"], sorted(call.get("signals", {})), sorted(call["numbers"])]
            form.append(call.get("evaluation", {}))
            members.setdefault(json.dumps(form, sort_keys=True), []).append((row, call))
        self._count = len(world.scenes)
        self._forms = [_form(found, world, registry) for found in members.values()]

    @property
    def looks_back(self) -> int:
        """How many samples before now it depends on."""
        calls = [call for form in self._forms for call in form.signals.values()]
        return int(max((call.looks_back for call in calls), default=0))

    def values(self, samples: Samples) -> Floats:
        """(S,) the margins now, within the bounds of rewards."""
        if len(self._forms) == 1:  # of all scenes, in their order
            out = self._forms[0].values(samples)
        else:
            out = np.empty(self._count)
            for form in self._forms:
                out[form.rows] = form.values(samples)
        return np.minimum(np.maximum(out, -MOST), MOST)


def margin_formula(verdict: Verdict, registry: Registry) -> stl.Formula | None:
    """The formula whose robustness is the margin of an expectation: `p` of `always p`.

    None where it is not known from what is now and a moment before: with further temporal
    operators, signals that look farther back, `time`, robustness that is a shift in time, and
    monitors. Semantics between samples and averages over windows change nothing at a sample.
    """
    if verdict.domain != "drive" or verdict.formula is None or "monitor" in verdict.formula:
        return None
    if evaluation_from_json(verdict.formula.get("evaluation", {})).is_shift:
        return None
    formula = stl.from_json(verdict.formula["formula"])
    if isinstance(formula, stl.Always | stl.Eventually):
        formula = formula.operand
    if formula.temporal:
        return None
    calls: Mapping[str, Any] = verdict.formula.get("signals", {})
    for call in calls.values():
        entry = entry_of(registry, "drive_signal", str(call["kind"]))
        if math.isinf(drive_signal_kind(entry).looks_back):
            return None
        if not named_entities(entry, call.get("options", {})):
            return None
    return formula


def _condition(name: str, scene: Scene) -> Mapping[str, Any]:
    for verdict in scene.expectations:
        if verdict.name == name and verdict.formula is not None:
            return verdict.formula
    fault = diagnose(Code.NOT_A_REWARD, name=name, reason="a scene has no `expect` of this name")
    raise DiagnosticError(fault)


def _form(
    members: Sequence[tuple[int, Mapping[str, Any]]],
    world: World,
    registry: Registry,
) -> _Form:
    rows = np.array([row for row, _ in members], dtype=np.int64)
    first = members[0][1]
    formula = stl.from_json(first["formula"])
    if isinstance(formula, stl.Always | stl.Eventually):
        formula = formula.operand
    evaluation = evaluation_from_json(first.get("evaluation", {}))
    if not evaluation.weights:
        formula = stl.normal_form(formula)
    signals = {}
    for name, call in first.get("signals", {}).items():
        kind = str(call["kind"])
        kinds = {kind: entry_of(registry, "drive_signal", kind)}
        calls = [condition["signals"][name] for _, condition in members]
        signals[name] = SignalCall(calls, rows.tolist(), world, kinds)
    numbers = {
        number: np.array([float(condition["numbers"][number]) for _, condition in members])
        for number in first["numbers"]
    }
    return _Form(rows, formula, evaluation, signals, numbers)


def _robustness(formula: stl.Formula, value: Signal, count: int) -> Floats:
    """(R,) of a formula in normal form without temporal operators, as `stl` computes it."""
    match formula:
        case stl.Truth(truth):
            return np.full(count, math.inf if truth else -math.inf)
        case stl.Comparison(op, left, right):
            sides = (term_values(side, value, count) for side in (left, right))
            return np.asarray(OF_INFINITIES[ROBUST[op]](*sides))
        case stl.LogicalJunction():
            join = np.minimum if formula.least else np.maximum
            parts = [_robustness(part, value, count) for part in formula.parts]
            return np.asarray(join.reduce(parts))
    raise AssertionError(f"not in normal form: {formula}")
