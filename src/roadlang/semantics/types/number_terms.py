"""Numbers of the scene as terms of a formula, and values as text."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from ...ir.values import (
    ConstantValue,
    Entity,
    Entries,
    Flag,
    Items,
    Measure,
    NumberBinding,
    Operation,
    Options,
    PassCall,
    RandomValue,
    Reference,
    SignalBinding,
    TextValue,
    Value,
)
from ...stl.formula import terms as t

B = TypeVar("B", SignalBinding, NumberBinding)


def term_of(value: Value) -> tuple[t.Term, tuple[NumberBinding, ...]]:
    """The term of a number, with a variable for each thing in it that a scene decides."""
    if isinstance(value, ConstantValue):
        return t.Constant(value.value), ()
    if not isinstance(value, Operation):
        variable = text_of(value)
        return t.Variable(variable), (NumberBinding(variable, value),)
    parts = [term_of(operand) for operand in value.operands]
    terms = [term for term, _ in parts]
    bindings = distinct(binding for _, found in parts for binding in found)
    if value.operator == "negate":
        return t.Negate(terms[0]), bindings
    if value.operator in ("abs", "min", "max"):
        return t.Apply(value.operator, tuple(terms)), bindings  # type: ignore[arg-type]
    return t.Arithmetic(value.operator, terms[0], terms[1]), bindings  # type: ignore[arg-type]


def distinct(bindings: Iterable[B]) -> tuple[B, ...]:
    """The bindings without repeats; a variable stands for one thing."""
    by_variable: dict[str, B] = {}
    for binding in bindings:
        by_variable.setdefault(binding.variable, binding)
    return tuple(by_variable.values())


def text_of(value: Value | None) -> str:
    """A value as the language writes it, in SI units; it names variables of formulas."""
    match value:
        case ConstantValue(number, dimension):
            return f"{number:.12g}{_glued(dimension.unit)}"
        case Flag(flag):
            return "true" if flag else "false"
        case TextValue(text) | Reference(text):
            return text
        case Entity():
            return value.text
        case RandomValue(place=place):
            return place
        case Measure(call):
            return call.place
        case Items(items):
            return "(" + ", ".join(text_of(item) for item in items) + ")"
        case Entries(entries):
            return "{" + ", ".join(f"{key}: {text_of(item)}" for key, item in entries.items()) + "}"
        case Operation("negate", (operand,)):
            return f"-({text_of(operand)})"
        case Operation(operator, operands) if operator in ("abs", "min", "max"):
            return f"{operator}({', '.join(text_of(operand) for operand in operands)})"
        case Operation(operator, (left, right)):
            return f"({text_of(left)} {operator} {text_of(right)})"
        case PassCall():
            return call_text(value.kind.split(".")[-1], value.options)
    return ""


def call_text(name: str, options: Options) -> str:
    """`curvature(bent)`: what a signal or number is called in reports."""
    return f"{name}({', '.join(text_of(value) for value in options.values())})"


def _glued(unit: str) -> str:
    return unit.removeprefix("1") if unit.startswith("1/") else unit
