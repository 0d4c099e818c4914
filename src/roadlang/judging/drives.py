"""Judges the `expect`s of a scene on the trace of its drive."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from types import MappingProxyType
from typing import Any

import numpy as np

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..geometry.arrays import Floats
from ..ir.scene import Scene, Verdict
from ..ir.trace import AgentTrace, Trace
from ..plugins.drive_signals import drive_signal_values, named_entities
from ..plugins.finding import entry_of
from ..plugins.guard import plugin_guard, wrong_result
from ..plugins.registry import KindEntry, Registry
from ..plugins.results import robustness_values
from ..stl import Formula
from ..stl.evaluate.measured_robustness import measured_rho, satisfied_by
from ..stl.evaluate.satisfaction import zero_satisfies
from ..stl.formula.evaluation_options import EvaluationOptions
from .drive_formulas import DriveFormula, VariableSignal, drive_formula
from .unrecorded_columns import unrecorded_columns
from .verdicts import decided
from .window_warnings import JudgedAxis, window_warnings

NO_ROBUSTNESS: Mapping[str, float] = MappingProxyType({})


@dataclass(frozen=True)
class Judgment:
    """The verdicts on a drive. An expectation that cannot be evaluated has no robustness there, and
    its diagnostics are in `faults`, by its name; `warnings`, by name: windows without samples."""

    verdicts: tuple[Verdict, ...]
    faults: Mapping[str, tuple[Diagnostic, ...]]
    warnings: Mapping[str, tuple[Diagnostic, ...]]

    def faults_at(self, places: Mapping[str, Span | None]) -> Mapping[str, tuple[Diagnostic, ...]]:
        """The faults, those without a place at that of their expectation."""
        return {
            name: tuple(replace(each, span=each.span or places.get(name)) for each in found)
            for name, found in self.faults.items()
        }


def judge(
    scene: Scene, trace: Trace, registry: Registry, known: Mapping[str, float] = NO_ROBUSTNESS
) -> Judgment:
    """The expectations with robustness; those over roads were judged when the scene was made.
    `known`: the robustness of some, by name.

    A member signal of a group (`walkers.speed`) makes the formula hold for each of its members;
    `distance` to a group is that to the nearest.
    """
    verdicts: list[Verdict] = []
    faults: dict[str, tuple[Diagnostic, ...]] = {}
    warnings: dict[str, tuple[Diagnostic, ...]] = {}
    for verdict in scene.expectations:
        try:
            if verdict.domain == "drive" and verdict.formula is not None:
                rho = known.get(verdict.name)
                found, warned = _judged(verdict, verdict.formula, trace, registry, rho)
                verdicts.append(found)
                if warned:
                    warnings[verdict.name] = warned
            else:
                verdicts.append(verdict)
        except DiagnosticError as error:  # the other expectations and the trace are as good
            verdicts.append(verdict)
            faults[verdict.name] = error.diagnostics
    return Judgment(tuple(verdicts), faults, warnings)


def _judged(
    verdict: Verdict, test: Mapping[str, Any], trace: Trace, registry: Registry, rho: float | None
) -> tuple[Verdict, tuple[Diagnostic, ...]]:
    if "monitor" in test:
        return decided(verdict, _monitored(test, trace, registry), zero_satisfies), ()
    condition = DriveCondition(test, trace, registry)
    rho = condition.rho if rho is None else rho
    found = decided(verdict, rho, lambda rows: condition.truth)
    axis = JudgedAxis("the drive", trace.time)
    return found, tuple(window_warnings(condition.formula, condition.evaluation, [axis]))


@dataclass(frozen=True)
class DriveCondition:
    """A condition `{formula, signals, numbers}` on a trace, for every member of a group."""

    condition: Mapping[str, Any]
    trace: Trace
    registry: Registry

    @property
    def rho(self) -> float:
        """Robustness, of the worst member."""
        return min((self.rho_of(values) for _, values in self.choices()), default=math.inf)

    @property
    def truth(self) -> bool:
        """Boolean satisfaction, by every member."""
        formula, time, options = self.formula, self.trace.time, self.evaluation
        choices = (values for _, values in self.choices())
        return all(bool(satisfied_by(formula, time, values, options)) for values in choices)

    def rho_of(self, values: Mapping[str, Any]) -> float:
        """Robustness for the values of one choice of members."""
        return float(measured_rho(self.formula, self.trace.time, values, self.evaluation))

    @property
    def formula(self) -> Formula:
        """The formula by itself."""
        return self.said.formula

    @property
    def evaluation(self) -> EvaluationOptions:
        """How it is evaluated."""
        return self.said.evaluation

    @cached_property
    def said(self) -> DriveFormula:
        """What it says, the same object for all drives of scenes that share it."""
        return drive_formula(self.condition, self.registry)

    def choices(self) -> Iterator[tuple[dict[str, AgentTrace], dict[str, Any]]]:
        """For every choice of a member of each group: the members by group, and the variables of
        the formula."""
        said = self.said
        members = sorted(frozenset[str]().union(*(signal.members for signal in said.signals)))
        for choice in product(*(self.trace.named(name) for name in members)):
            chosen = dict(zip(members, choice, strict=True))
            values = {signal.variable: self._values(signal, chosen) for signal in said.signals}
            yield chosen, {**said.numbers, **values}

    def _values(self, signal: VariableSignal, chosen: Mapping[str, AgentTrace]) -> Floats:
        """(T,) a signal of the members `chosen`. Raises RL470, RL474, RL701."""
        trace, entry = self.trace, signal.entry

        def options(of: Trace) -> dict[str, Any]:
            """With the agents of a trace in the place of their names."""
            named = {
                key: of.agents[chosen[name].name] if signal.is_member else of.named(name)
                for key, name in signal.entities.items()
            }
            return {**signal.options, **named}

        values = drive_signal_values(entry, options(trace), trace)
        if values.shape != trace.time.shape:
            fault = f"gave values of shape {values.shape}, not {trace.time.shape}"
            raise wrong_result(entry, None, fault)
        unknown = np.isnan(values)
        if unknown.any():
            missing = unrecorded_columns(entry, options, trace)
            if not missing:
                fault = f"gave NaN at {trace.time[unknown.argmax()]:g} s"
                raise wrong_result(entry, None, fault)
            raise _not_recorded(signal.variable, trace.engine, missing)
        return values


def _not_recorded(signal: str, engine: str, columns: tuple[str, ...]) -> DiagnosticError:
    listed = ", ".join(f"`{column}`" for column in columns)
    help_ = f"the trace has no value of {listed} at some times, or at all times"
    return DiagnosticError(
        diagnose(Code.SIGNAL_NOT_RECORDED, signal=signal, engine=engine, help=help_)
    )


def _monitored(call: Mapping[str, Any], trace: Trace, registry: Registry) -> float:
    """Robustness, of the worst member of the groups that the monitor names."""
    entry = entry_of(registry, "monitor", str(call["monitor"]))
    options = call.get("options", {})
    named = named_entities(entry, options)
    members = product(*(trace.named(name) for name in named.values()))
    found = [
        _monitored_once(entry, {**options, **dict(zip(named, chosen, strict=True))}, trace)
        for chosen in members
    ]
    return min(found, default=math.inf)


def _monitored_once(entry: KindEntry, options: Mapping[str, Any], trace: Trace) -> float:
    with plugin_guard(entry, None):
        kind: Any = entry.load()
        found = kind(**options).judge(trace)
    rho = robustness_values(found, entry, None)
    if rho.size != 1:
        raise wrong_result(entry, None, f"gave a robustness of shape {rho.shape}, not one number")
    return rho.item()
