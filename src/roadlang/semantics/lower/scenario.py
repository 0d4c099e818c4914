"""From the checked program to the scenario, each group in an order that can be evaluated."""

from __future__ import annotations

from typing import Any

from ...diagnostics import Code, Label
from ...ir import scenario as ir
from ...ir.recorded_names import recorded_name
from ..checker import Checker
from ..names.definition_order import definition_order
from ..names.program import PlacedStatement
from .evaluation_order import evaluation_order
from .named_values import named_signals
from .statements import STATEMENTS

_NAMED_VALUES = ("param", "let")
"""Statements that may name a signal or a formula, which is in no scenario by itself"""


def lower(checker: Checker) -> ir.Scenario:
    """The scenario; where errors were reported it lacks what they concern."""
    program = checker.program
    for name in definition_order(program, "param", "let"):
        checker.definition(name)
    lowered = {
        name: _lower_statement(checker, declaration)
        for name, declaration in program.declarations.items()
    }
    unnamed = _unnamed(checker)
    order = evaluation_order(checker)
    _refuse_lost(checker, lowered)
    groups: dict[str, list[Any]] = {}
    for name in order:
        spec = STATEMENTS[program.declarations[name].role]
        if not spec.as_written and lowered[name] is not None:
            groups.setdefault(spec.scenario_field, []).append(lowered[name])
    for name, declaration in program.declarations.items():
        spec = STATEMENTS[declaration.role]
        if spec.as_written and lowered[name] is not None:
            groups.setdefault(spec.scenario_field, []).append(lowered[name])
    return ir.Scenario(
        header=_header(checker),
        signals=named_signals(checker),
        inputs=tuple(ir.Input(path) for path in dict.fromkeys(program.inputs)),
        **{field: tuple(found) for field, found in groups.items()} | unnamed,
    )


def _refuse_lost(checker: Checker, lowered: dict[str, Any]) -> None:
    """A bug, not a scenario without it, where a declaration is left out and nothing says why."""
    if not checker.has_errors:
        roles = {name: checker.program.declarations[name].role for name in lowered}
        lost = [
            n for n, found in lowered.items() if found is None and roles[n] not in _NAMED_VALUES
        ]
        assert not lost, f"nothing says why {', '.join(lost)} is left out"


def _lower_statement(checker: Checker, declaration: PlacedStatement) -> Any:
    spec = STATEMENTS[declaration.role]
    return spec.lower(checker, spec, declaration)


def _header(checker: Checker) -> ir.ScenarioHeader:
    program = checker.program
    if not program.headers:
        return ir.ScenarioHeader(recorded_name(program.path.stem))
    header = program.headers[0]
    return ir.ScenarioHeader(header.name.text, header.title.value if header.title else "")


def _unnamed(checker: Checker) -> dict[str, Any]:
    """What the statements without a name lower to, by the field of the scenario."""
    fields: dict[str, Any] = {}
    for spec in STATEMENTS.values():
        found = [statement for statement in checker.program.unnamed if statement.role == spec.word]
        if not found:
            continue
        if spec.once:
            _report_others(checker, found)
            fields[spec.scenario_field] = _lower_statement(checker, found[0])
        else:
            lowered = [_lower_statement(checker, declaration) for declaration in found]
            fields[spec.scenario_field] = tuple(
                statement for statement in lowered if statement is not None
            )
    return fields


def _report_others(checker: Checker, found: list[PlacedStatement]) -> None:
    """A statement that may be there once: each further one is reported."""
    for extra in found[1:]:
        labels = [Label(found[0].statement.span, "the first one")]
        span = extra.statement.span
        keyword = span.source.span(span.start, span.start + len(extra.role))
        checker.report(Code.DUPLICATE_STATEMENT, keyword, labels=labels, word=extra.role)
