"""From the checked program to the scenario, each group in an order that can be evaluated."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from ...diagnostics import Code, Label
from ...ir import scenario as ir
from ...ir.dimension import Dimension
from ...ir.values import PassCall
from ...stl import Comparison, Constant
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..infer.formulas import condition_of
from ..names.definition_order import definition_order
from ..names.program import Declaration, Placed
from ..types.expression_types import Quantity, SignalType, TypedExpression
from .actors import lower_actor
from .constraints import lower_constraint
from .evaluation_order import evaluation_order
from .geometry import lower_geometry
from .run import lower_emit, lower_plan
from .world import lower_world

_LOWER = {
    "image": lower_geometry,
    "network": lower_geometry,
    "road": lower_geometry,
    "agent": lower_actor,
    "object": lower_actor,
    "require": lower_constraint,
    "expect": lower_constraint,
}


def lower(checker: Checker) -> ir.Scenario:
    """The scenario; where errors were reported it lacks what they concern."""
    program = checker.program
    for name in definition_order(program):
        checker.definition(name)
    made: dict[str, Any] = {}
    for name, declaration in program.declarations.items():
        made[name] = _lower_one(checker, declaration)
    unnamed = _unnamed(checker)
    order = evaluation_order(checker)

    def of(*roles: str) -> tuple[Any, ...]:
        wanted = (name for name in order if program.declarations[name].role in roles)
        return tuple(made[name] for name in wanted if made[name] is not None)

    def as_written(role: str) -> tuple[Any, ...]:
        wanted = (found.name.text for found in program.in_role(role))
        return tuple(made[name] for name in wanted if made[name] is not None)

    return ir.Scenario(
        header=_header(checker),
        values=of("param", "let"),
        images=of("image"),
        networks=of("network"),
        roads=of("road"),
        signals=_signals(checker),
        requirements=as_written("require"),
        expectations=as_written("expect"),
        agents=of("agent"),
        objects=of("object"),
        inputs=tuple(ir.Input(path) for path in dict.fromkeys(program.inputs)),
        **unnamed,
    )


def _lower_one(checker: Checker, declaration: Declaration) -> Any:
    if declaration.role in ("param", "let"):
        return _named(declaration, checker.definition(declaration.name.text))
    return _LOWER[declaration.role](checker, declaration)


def _named(declaration: Declaration, typed: TypedExpression) -> ir.Named | None:
    if typed.value is None:
        return None
    dimension: Dimension | None = None
    if isinstance(typed.type, Quantity):
        dimension = typed.type.dimension
    is_param = declaration.role == "param"
    span = declaration.statement.span
    return ir.Named(declaration.name.text, typed.value, dimension, is_param, span)


def _signals(checker: Checker) -> tuple[ir.NamedSignal, ...]:
    """The `let`s that name signals over roads, as written."""
    found = []
    for declaration in checker.program.in_role("let"):
        typed = checker.definition(declaration.name.text)
        if isinstance(typed.type, SignalType) and typed.type.domain == "road":
            assert typed.term is not None
            above_zero = Comparison(">=", typed.term, Constant(0.0))
            condition = condition_of(replace(typed, formula=above_zero))
            span = declaration.statement.span
            name = declaration.name.text
            found.append(ir.NamedSignal(name, condition, typed.type.dimension, span))
    return tuple(found)


def _header(checker: Checker) -> ir.Header:
    program = checker.program
    if not program.headers:
        return ir.Header(program.path.stem)
    header = program.headers[0]
    return ir.Header(header.name.text, header.title.value if header.title else "")


def _unnamed(checker: Checker) -> dict[str, Any]:
    placed = checker.program.unnamed
    made: dict[str, Any] = {"world": ()}
    world = _only_one(checker, "world", _of(placed, ast.World))
    if world is not None:
        made["world"] = lower_world(checker, world)
    for word in ("sample", "simulate", "falsify"):
        plans = [found for found in _of(placed, ast.Plan) if found.statement.word == word]  # type: ignore[union-attr]
        plan = _only_one(checker, word, plans)
        made[word] = lower_plan(checker, plan) if plan is not None else None
    emits: list[PassCall] = []
    for number, found in enumerate(_of(placed, ast.Emit), start=1):
        call = lower_emit(checker, found, number)
        if call is not None:
            emits.append(call)
    made["emits"] = tuple(emits)
    return made


def _of(placed: Iterable[Placed], kind: type) -> list[Placed]:
    return [found for found in placed if isinstance(found.statement, kind)]


def _only_one(checker: Checker, word: str, found: list[Placed]) -> Placed | None:
    """The statement that may be there once; each further one is reported."""
    for extra in found[1:]:
        labels = [Label(found[0].statement.span, "the first one")]
        span = extra.statement.span
        keyword = span.source.span(span.start, span.start + len(word))
        checker.report(Code.DUPLICATE_STATEMENT, keyword, labels=labels, word=word)
    return found[0] if found else None
