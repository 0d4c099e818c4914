"""The plan of a search: what the `falsify` of the scene file says, and what comes before it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from ..evaluate.candidates import fixed_candidate
from ..evaluate.evaluation import build, evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import scalar
from ..ir.scenario import Scenario
from ..ir.values import PassCall
from ..plugins.common_options import FalsifyOptions
from ..plugins.configured import configured
from ..plugins.finding import entry_of
from ..plugins.given_options import given_options, option_faults
from ..plugins.options import schema_of
from .plan import Plan

SETTINGS = tuple(option.name for option in schema_of(FalsifyOptions))
"""The options that every `falsify` has."""
_EXPECT = "add one, such as `expect slow: always (ego.speed < 50km/h)`"


def plan_of(
    scenario: IndexedScenario, seed: int, searcher: str | None, overrides: Mapping[str, Any]
) -> tuple[Plan, tuple[str, ...]]:
    """The plan and the expectations to violate, the most important first.

    `searcher` and `overrides` (values of `SETTINGS`, None where not set) precede the scene file.
    Raises `DiagnosticError` RL703 where there is nothing to violate, RL930 for a searcher that does
    not exist, RL220 for a setting that does not, RL206 and RL208 for values of one.
    """
    schemas = schema_of(FalsifyOptions)
    given = {name: value for name, value in overrides.items() if value is not None}
    given = given_options(schemas, given)
    faults = option_faults("`falsify`", schemas, given)
    if faults:
        raise DiagnosticError(*faults)
    settings = _settings(scenario) | given
    expects = _expects(scenario.source, settings.pop("expects"))
    call = scenario.source.falsify
    registry = scenario.registry
    if searcher is None and call is None:
        searcher = registry.default("falsify").qualified
    if call is not None and (
        searcher is None or entry_of(registry, "falsify", searcher).qualified == call.kind
    ):
        built = build(call, fixed_candidate(scenario), single=True)
        entry, kind, span = built.entry, built.kind, call.span
    else:
        assert searcher is not None
        (entry, kind), span = configured(registry, "falsify", searcher, {}), None
    return Plan(kind, entry, seed, span=span, **settings), expects


def _settings(scenario: IndexedScenario) -> dict[str, Any]:
    """The options of the statement, defaults included."""
    found = {option.name: option.default for option in schema_of(FalsifyOptions)}
    call: PassCall | None = scenario.source.falsify
    for name, value in call.common.items() if call is not None else ():
        found[name] = scalar(evaluate(value, fixed_candidate(scenario)))
    for name in ("evaluations", "batch", "islands", "failures"):
        found[name] = None if found[name] is None else round(found[name])
    return found


def _expects(source: Scenario, names: Sequence[str]) -> tuple[str, ...]:
    declared = [item.name for item in source.expectations]
    if not declared:
        raise DiagnosticError(diagnose(Code.NOTHING_TO_FALSIFY, help=_EXPECT))
    for name in names:
        if name not in declared:
            help_ = did_you_mean(name, declared) or (f"there are {', '.join(declared)}",)
            fault = diagnose(Code.UNKNOWN_CHOICE, what="expectation", name=name, help=help_)
            raise DiagnosticError(fault)
    return tuple(dict.fromkeys(names)) or tuple(declared)
