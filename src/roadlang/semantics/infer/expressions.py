"""Literals, names, arithmetic, draws, lists: everything but calls and formulas."""

from __future__ import annotations

import math
from dataclasses import replace

from ...diagnostics import Code, Span
from ...ir.read_only import FrozenDict
from ...ir.values import (
    ConstantValue,
    Entity,
    Entries,
    Flag,
    Items,
    Operation,
    PassCall,
    RandomValue,
    Reference,
    SignalBinding,
    TextValue,
)
from ...stl.evaluate.interval_arithmetic import negated as negated_bounds
from ...stl.formula.formulas import Truth
from ...stl.formula.terms import Variable
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..names.program import expression_of
from ..types.arithmetic import signal_arithmetic, signal_negation
from ..types.dimensions import common_dimension
from ..types.expression_types import (
    BooleanType,
    ConstraintType,
    CoordinatesType,
    DeclaredType,
    DomainEvidence,
    MappingType,
    Quantity,
    SequenceType,
    SignalType,
    StringType,
    TypedExpression,
    unknown,
)
from ..types.range_or_interval import drawn_between
from .habits import number_of_entity_help
from .kinds import find_default, verbs_with
from .unresolved_names import report_unresolved


def infer_string(
    checker: Checker, string: ast.String | ast.Text, context: Context
) -> TypedExpression:
    """A string or bare text: a word that options may accept."""
    return TypedExpression(
        string.span, StringType(frozenset({string.value})), TextValue(string.value)
    )


def infer_boolean(checker: Checker, boolean: ast.Boolean, context: Context) -> TypedExpression:
    """`true` or `false`, as a flag and as a formula."""
    return TypedExpression(
        boolean.span, BooleanType(), Flag(boolean.value), formula=Truth(boolean.value)
    )


def infer_group(checker: Checker, group: ast.GroupExpression, context: Context) -> TypedExpression:
    """Parentheses: what is inside them."""
    return checker.infer(group.inner, context)


def infer_negation(
    checker: Checker, negation: ast.NegateExpression, context: Context
) -> TypedExpression:
    """`-x` of a number or signal."""
    operand = checker.infer(negation.operand, context)
    if operand.is_unknown:
        return operand
    if isinstance(operand.type, SignalType):
        return signal_negation(operand, negation.span)
    if not isinstance(operand.type, Quantity):
        return checker.report(
            Code.WRONG_TYPE, operand.span, what="`-`", expected="a number", found=operand.type
        )
    value = operand.value
    assert value is not None
    negated = (
        ConstantValue(-value.value, value.dimension)
        if isinstance(value, ConstantValue)
        else Operation("negate", (value,))
    )
    return replace(
        operand, span=negation.span, value=negated, bounds=negated_bounds(operand.bounds)
    )


def infer_arithmetic(
    checker: Checker, node: ast.ArithmeticExpression, context: Context
) -> TypedExpression:
    """`+ - * / ^` of numbers, or of signals and numbers."""
    left = checker.infer(node.left, context)
    right = checker.infer(node.right, context)
    if left.is_unknown or right.is_unknown:
        return unknown(node.span)
    for side in (left, right):
        if not isinstance(side.type, Quantity | SignalType):
            sign = f"`{node.operator}`"
            return checker.report(
                Code.WRONG_TYPE, side.span, what=sign, expected="a number", found=side.type,
                help=number_of_entity_help(side) or drawn_between(side),
            )  # fmt: skip
    return signal_arithmetic(checker, node, left, right)


def infer_draw(checker: Checker, draw: ast.Draw, context: Context) -> TypedExpression:
    """`low..high`: a uniform draw."""
    ends = [checker.infer(end, context) for end in (draw.low, draw.high)]
    if any(end.is_unknown for end in ends):
        return unknown(draw.span)
    for end in ends:
        if not isinstance(end.type, Quantity):
            return checker.report(
                Code.WRONG_TYPE, end.span, what="`..`", expected="a number", found=end.type
            )
    dimension = common_dimension(checker, ends, "the two ends of a range")
    if dimension is None:
        return unknown(draw.span)
    low, high = ends
    if any(end.constant is not None and math.isinf(end.constant) for end in ends):
        return checker.report(Code.NOT_FINITE, draw.span, what="a range that is drawn from")
    if low.constant is not None and high.constant is not None and low.constant > high.constant:
        text = f"{draw.high.span.text}..{draw.low.span.text}"
        return checker.report(Code.REVERSED_RANGE, draw.span, what="range", help=f"write `{text}`")
    found = find_default(checker, "distribution", draw.span)
    if found is None or low.value is None or high.value is None:
        return unknown(draw.span)
    place = checker.draw_place(context)
    options = FrozenDict({"low": low.value, "high": high.value})
    call = PassCall("distribution", found.entry.qualified, options, place, draw.span)
    kinds = [end.type for end in ends if isinstance(end.type, Quantity)]
    kind = Quantity(
        dimension,
        fits_any=all(k.fits_any for k in kinds),
        bare=all(k.bare for k in kinds),
        is_integer=low.constant is not None
        and low.constant == high.constant
        and kinds[0].is_integer,
    )
    value = RandomValue(place, call, context.per, dimension)
    bounds = checker.bounds_of(value)
    return TypedExpression(draw.span, kind, value, random=True, bounds=bounds, range=True)


def infer_point(checker: Checker, point: ast.Point, context: Context) -> TypedExpression:
    """`(x, y)`: each item separately."""
    items = tuple(checker.infer(item, context) for item in point.items)
    return _collected(TypedExpression(point.span, CoordinatesType(), items=items))


def infer_list(checker: Checker, items: ast.ListValue, context: Context) -> TypedExpression:
    """`[a, b, ...]`: each item separately."""
    parts = tuple(checker.infer(item, context) for item in items.items)
    return _collected(TypedExpression(items.span, SequenceType(), items=parts))


def infer_map(checker: Checker, node: ast.MapValue, context: Context) -> TypedExpression:
    """`{ key: value }`; a key that is there twice is an error."""
    keys: list[tuple[str, Span]] = []
    items: list[TypedExpression] = []
    for entry in node.entries:
        key = entry.key.value if isinstance(entry.key, ast.String) else entry.key.text
        if key in (known for known, _ in keys):
            checker.report(Code.DUPLICATE_OPTION, entry.key.span, name=key)
            continue
        keys.append((key, entry.key.span))
        inner = replace(context, place=f"{context.place}/{key}")
        items.append(checker.infer(entry.value, inner))
    found = TypedExpression(node.span, MappingType(), items=tuple(items), keys=tuple(keys))
    values = [item.value for item in items]
    if any(value is None for value in values):
        return found
    named = {key: value for (key, _), value in zip(keys, values, strict=True) if value}
    return replace(
        found, value=Entries(FrozenDict(named)), random=any(item.random for item in items)
    )


def _collected(typed: TypedExpression) -> TypedExpression:
    values = tuple(item.value for item in typed.items if item.value is not None)
    if len(values) < len(typed.items):
        return typed
    random = any(item.random for item in typed.items)
    return replace(typed, value=Items(values), random=random)


def infer_name(checker: Checker, name: ast.Name, context: Context) -> TypedExpression:
    """A word of the option, a declared thing, a kind, a built-in name."""
    text, word = name.text, name.word
    if word in context.words:
        return TypedExpression(name.span, StringType(frozenset({word}), word=True), TextValue(word))
    declaration = checker.program.declarations.get(text)
    if text in checker.program.spoiled and text != "time":
        return unknown(name.span)
    verb = _expected_verb(checker, word, context)
    if declaration is not None and verb is None:
        return _declared(checker, name, declaration.role, context)
    if text == "inf":
        kind = Quantity(fits_any=True)
        return TypedExpression(
            name.span, kind, ConstantValue(math.inf), bounds=(math.inf, math.inf)
        )
    if text == "time":
        return checker.infer(ast.CallExpression(name, (), span=name.span), context)
    verb = verb or _verb_in_definition(checker, text, context)
    if verb is not None:
        return checker.infer(
            ast.CallExpression(name, (), span=name.span), replace(context, verbs=(verb,))
        )
    if context.strings:
        return TypedExpression(name.span, StringType(frozenset({text})), TextValue(text))
    return report_unresolved(checker, name, context)


def _declared(checker: Checker, name: ast.Name, role: str, context: Context) -> TypedExpression:
    text, span = name.text, name.span
    if context.watches and text == context.user and role in context.roles:
        return _itself(checker, name, context)
    checker.use(text, context)
    if role in ("require", "expect"):
        return TypedExpression(span, ConstraintType(role), TextValue(text))
    if role not in ("param", "let"):
        return TypedExpression(span, DeclaredType(role), Entity(text, role))
    found = checker.definition(text)
    if found.is_unknown:
        return unknown(span)
    if context.fresh and found.random and found.value is not None:
        again = checker.infer(expression_of(checker.program, text), context)
        return replace(again, span=span, range=False)
    if found.value is None:
        return _signal_or_formula(found, text, span)
    if isinstance(found.type, Quantity):
        constant = isinstance(found.value, ConstantValue)
        value = found.value if constant else Reference(text)
        kind = replace(found.type, bare=False)
        return replace(found, span=span, type=kind, value=value, range=False)
    return replace(found, span=span, value=Reference(text), range=False)


def _itself(checker: Checker, name: ast.Name, context: Context) -> TypedExpression:
    """RL228 of a controller that is told to watch the agent that it drives."""
    checker.report(
        Code.WRONG_ENTITY_TYPE,
        name.span,
        what=f"`{context.place.rpartition('/')[2]}`",
        expected=f"another {' or '.join(context.roles)}",
        name=name.text,
        found="the agent that this controller drives",
    )
    return unknown(name.span)


def _signal_or_formula(found: TypedExpression, text: str, span: Span) -> TypedExpression:
    """What a `let` names; a signal alone is a variable of that name in formulas."""
    evidence = DomainEvidence(found.evidence.domain, span, text) if found.evidence else None
    if not isinstance(found.term, Variable) or len(found.signals) != 1:
        return replace(found, span=span, evidence=evidence)
    signal = found.signals[0]
    signals = (SignalBinding(text, signal.call, signal.dimension),)
    return replace(found, span=span, evidence=evidence, term=Variable(text), signals=signals)


def _expected_verb(checker: Checker, text: str, context: Context) -> str | None:
    """The verb of the kind that a bare name means where kinds are expected: `is car`."""
    return next(iter(verbs_with(checker, context.verbs, text)), None)


def _verb_in_definition(checker: Checker, text: str, context: Context) -> str | None:
    """Where nothing says what is expected, a name that is not declared may be a kind."""
    declared = checker.program.declarations.get(context.user)
    if declared is None or declared.role not in ("param", "let"):
        return None
    return next(iter(checker.registry.shipped_first(("agent", "object"), text)), None)
