"""Calls: built-in functions, signals, numbers of the scene, draws, pieces."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ...diagnostics import Code
from ...ir.values import Entity, PassCall
from ...plugins.common_options import common_options
from ...plugins.option_types import EntityType as EntityOption
from ...plugins.option_types import UnionType
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker, ResolvedKind
from ..context import Context
from ..suggestions import meant_name
from ..types.arithmetic import of_functions, signal_of_functions
from ..types.dimensions import common_dimension
from ..types.expression_types import KindCallType, Quantity, SignalType, TypedExpression, unknown
from .argument_binding import bind_arguments
from .draws import draw_of
from .group_copies import group_of, written_count
from .habits import function_help, monitor_help
from .kinds import FUNCTIONS, find_kind, verbs_with
from .option_binding import BoundOptions, divided
from .signals import measured

_COUNTS = {"abs": (1, 1), "min": (2, None), "max": (2, None), "fresh": (1, 1)}


def infer_call(checker: Checker, call: ast.CallExpression, context: Context) -> TypedExpression:
    """`f(x)`; which `f` is meant depends on what is expected here and, for overloads, on `x`."""
    name = dotted(call.function)
    if name is None:
        return checker.report(
            Code.UNKNOWN_FUNCTION, call.function.span, name=call.function.span.text
        )
    declared = name
    if isinstance(call.function, ast.Name):
        name = call.function.word
    if name in _COUNTS:
        return _built_in(checker, call, name, context)
    verbs = verbs_with(checker, context.verbs, name)[:1] or verbs_with(checker, FUNCTIONS, name)
    if not verbs and context.verbs == () and declared in checker.program.declarations:
        habit = function_help(call, name)
        if habit is None:  # else another function is meant, as in `expect ttc: always (ttc(a, b)`
            checker.use(declared, context)
        help_ = () if habit is None else habit[0]
        return checker.report(Code.NOT_A_FUNCTION, call.function.span, name=name, help=help_)
    if not verbs:
        return _no_function(checker, call, name, context)
    if len(verbs) == 1:
        return of_kind(checker, call, verbs[0], name, context)
    return _overloaded(checker, call, verbs, name, context)


def is_member(found: ResolvedKind) -> bool:
    """Whether a signal or number is written `ego.speed` rather than `speed(ego)`."""
    return found.kind.member


def dotted(expression: ast.Expression) -> str | None:
    """`acme.jerk` as one name; None if it is anything but names."""
    if isinstance(expression, ast.Name):
        return expression.text
    if isinstance(expression, ast.Member):
        inner = dotted(group_of(expression.of))
        return f"{inner}.{expression.name.text}" if inner else None
    return None


def _no_function(
    checker: Checker, call: ast.CallExpression, name: str, context: Context
) -> TypedExpression:
    span = call.function.span
    if context.verbs:
        find_kind(checker, context.verbs[0], name, span)
        return unknown(call.span)
    broken = checker.registry.broken_kind(FUNCTIONS, name)
    if broken is not None:
        plugin, reason = broken.origin, broken.reason
        checker.report(Code.BROKEN_PLUGIN, span, kind=name, plugin=plugin, reason=reason)
        return unknown(call.span)
    habit = function_help(call, name)
    if habit is not None:
        return checker.report(Code.UNKNOWN_FUNCTION, span, name=name, help=habit[0], fixes=habit[1])
    if checker.registry.has("monitor", name):
        return checker.report(Code.UNKNOWN_FUNCTION, span, name=name, help=monitor_help(name))
    known = {entry.name for verb in FUNCTIONS for entry in checker.registry.of(verb)} | {*_COUNTS}
    owner, dot, last = name.rpartition(".")
    if dot and last in known:
        arguments = ", ".join([owner, *(argument.span.text for argument in call.arguments)])
        help_ = f"write `{last}({arguments})`"
        return checker.report(Code.UNKNOWN_FUNCTION, span, name=name, help=help_)
    meant = meant_name(name, known)
    hints = () if meant else checker.registry.hints
    return checker.report(Code.UNKNOWN_FUNCTION, span, name=name, help=hints, meant=meant)


def _built_in(
    checker: Checker, call: ast.CallExpression, name: str, context: Context
) -> TypedExpression:
    if not _counted(checker, call, name):
        return unknown(call.span)
    if name == "fresh":
        return _fresh(checker, call, context)
    arguments = [checker.infer(argument.value, context) for argument in call.arguments]
    if any(argument.is_unknown for argument in arguments):
        return unknown(call.span)
    for typed in arguments:
        if not isinstance(typed.type, Quantity | SignalType):
            what, found = f"`{name}`", typed.type
            return checker.report(
                Code.WRONG_TYPE, typed.span, what=what, expected="a number", found=found
            )
    dimension = common_dimension(checker, arguments, "compared")
    if dimension is None:
        return unknown(call.span)
    if all(isinstance(argument.type, Quantity) for argument in arguments):
        return of_functions(name, arguments, call.span, dimension)
    return signal_of_functions(checker, name, arguments, call.span, dimension)


def _counted(checker: Checker, call: ast.CallExpression, name: str) -> bool:
    """Whether a built-in function has as many arguments as it takes, none of them named."""
    least, most = _COUNTS[name]
    count = len(call.arguments)
    if count < least or (most is not None and count > most):
        expected = "two or more arguments" if most is None else "one argument"
        span = call.arguments[most].span if most and count > most else call.span
        checker.report(
            Code.WRONG_ARGUMENT_COUNT, span, name=name, help=f"`{name}` takes {expected}"
        )
        return False
    for argument in call.arguments:
        if argument.key is not None:
            key = argument.key
            checker.report(Code.UNKNOWN_OPTION, key.span, name=key.text, owner=f"`{name}`")
            return False
    return True


def _fresh(checker: Checker, call: ast.CallExpression, context: Context) -> TypedExpression:
    value = call.arguments[0].value
    while isinstance(value, ast.GroupExpression):
        value = value.inner
    if not isinstance(value, ast.Name):
        return checker.report(Code.FRESH_WITHOUT_DRAW, value.span, what=value.span.text)
    typed = checker.infer(value, context)
    if typed.is_unknown:
        return typed
    declared = checker.program.declarations.get(value.text)
    if declared is None or declared.role not in ("param", "let") or not typed.random:
        return checker.report(Code.FRESH_WITHOUT_DRAW, value.span, what=value.text)
    again = checker.infer(value, replace(context, fresh=True))
    return replace(again, span=call.span)


def of_kind(
    checker: Checker, call: ast.CallExpression, verb: str, name: str, context: Context
) -> TypedExpression:
    """Type a call of the kind that is registered as `name` under `verb`."""
    found = find_kind(checker, verb, name, call.function.span)
    if found is None:
        return unknown(call.span)
    if is_member(found):
        argument = call.arguments[0].value if len(call.arguments) == 1 else None
        of = argument.text if isinstance(argument, ast.Name) else "ego"
        help_ = f"write `{of}.{name}`"
        return checker.report(Code.UNKNOWN_FUNCTION, call.function.span, name=name, help=help_)
    inner = context if verb == "distribution" else replace(context, words=(), verbs=(), roles=())
    rest = found.kind.rest
    schema = (*common_options(verb), *found.schema) if verb == "lane" else found.schema
    bound = bind_arguments(checker, call, schema, rest, inner)
    if not bound.complete:
        return unknown(call.span)
    if verb == "distribution":
        return draw_of(checker, call, found, bound, context)
    if verb in ("drive_signal", "number") and (operand := _named_twice(checker, verb, bound)):
        return checker.report(Code.COMPARED_WITH_ITSELF, call.span, name=name, operand=operand)
    if verb in ("signal", "drive_signal", "number"):
        return measured(checker, call.span, found, bound, name)
    random = any(typed.random for typed in bound.stated.values())
    names = {option.name for option in found.schema}
    options, common = divided(bound.values, names)
    kind, spans = found.entry.qualified, bound.spans
    value = PassCall(verb, kind, options, name, call.span, common, spans)
    return TypedExpression(call.span, KindCallType(verb), value, random)


def _named_twice(checker: Checker, verb: str, bound: BoundOptions) -> str | None:
    """The agent or object that two options name; where things are placed, a group has members that
    are apart."""
    named = [typed.value for typed in bound.stated.values() if isinstance(typed.value, Entity)]
    twice = [
        entity for entity in named if entity.role in ("agent", "object") and named.count(entity) > 1
    ]
    if verb == "number":
        twice = [e for e in twice if e.copy or written_count(checker, e.name) is None]
    return twice[0].text if twice else None


def _overloaded(
    checker: Checker, call: ast.CallExpression, verbs: list[str], name: str, context: Context
) -> TypedExpression:
    """The one of several functions whose options take what the arguments name."""
    roles = [_role(checker, argument.value) for argument in call.arguments]
    if any(role == "unknown" for role in roles):
        for argument in call.arguments:
            checker.infer(argument.value, context)
        return unknown(call.span)
    candidates: list[tuple[str, ResolvedKind]] = []
    user = checker.program.declarations.get(context.user)
    if user is not None and user.role == "require":  # where things are placed, not how they move
        verbs = sorted(verbs, key=lambda verb: verb == "drive_signal")
    for verb in verbs:
        found = find_kind(checker, verb, name, call.function.span)
        if found is not None:
            candidates.append((verb, found))
    for verb, found in candidates:
        if _takes(found.schema, roles) and not is_member(found):
            return of_kind(checker, call, verb, name, context)
    given = [checker.infer(argument.value, context) for argument in call.arguments]
    if any(typed.is_unknown for typed in given):
        return unknown(call.span)
    forms = dict.fromkeys(_form(name, found) for _, found in candidates)
    takes = " or ".join(forms)
    described = ", ".join(role or "a value" for role in roles)
    return checker.report(
        Code.UNDEFINED_SIGNAL, call.span, name=name, given=described, help=f"there is {takes}"
    )


def _form(name: str, found: ResolvedKind) -> str:
    """How a signal or number is written."""
    parameters = signature(found.schema)
    return f"`{parameters}.{name}`" if is_member(found) else f"`{name}({parameters})`"


def _role(checker: Checker, value: ast.Expression) -> str | None:
    """The role of the thing an argument names; None for values."""
    while isinstance(value, ast.GroupExpression):
        value = value.inner
    value = group_of(value)
    if not isinstance(value, ast.Name):
        return None
    declared = checker.program.declarations.get(value.text)
    if declared is None or value.text in checker.program.spoiled:
        return "unknown"
    return declared.role if declared.role not in ("param", "let") else None


def _takes(schema: tuple[OptionSchema, ...], roles: list[str | None]) -> bool:
    for option, role in zip(schema, roles, strict=False):
        expected = set(_roles_of(option))
        if (role is not None or expected) and role not in expected:
            return False
    return True


def takes_role(option: OptionSchema, role: str) -> bool:
    """Whether an option may name something of this role."""
    return role in _roles_of(option)


def _roles_of(option: OptionSchema) -> Iterable[str]:
    parts = option.type.alternatives if isinstance(option.type, UnionType) else (option.type,)
    return [role for part in parts if isinstance(part, EntityOption) for role in part.roles]


def signature(schema: tuple[OptionSchema, ...]) -> str:
    """The positional parameters of a kind, as messages show them."""
    return ", ".join(" or ".join(_roles_of(option)) or option.name for option in schema)
