"""Calls: built-in functions, signals, numbers of the scene, draws, pieces, members."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ..diagnostics import did_you_mean
from ..ir.values import Entity, Measure, PassCall
from ..plugins.kinds import DriveSignal
from ..plugins.option_types import EntityType as EntityOption
from ..plugins.option_types import UnionType
from ..plugins.options import OptionSchema
from ..syntax import ast
from .arguments import bind_arguments
from .arithmetic import common_domain, function_bounds, of_functions, terms_of
from .checker import Checker
from .context import Context
from .draws import draw_of
from .kinds import Found, find_kind
from .signals import measured
from .types import (
    CallType,
    EntityType,
    Quantity,
    SignalType,
    Typed,
    unknown,
)
from .units import common_dimension

_VERBS = ("signal", "drive_signal", "number", "distribution", "piece", "select")
_COUNTS = {"abs": (1, 1), "min": (2, None), "max": (2, None), "fresh": (1, 1)}


def infer_call(checker: Checker, call: ast.Call, context: Context) -> Typed:
    """`f(x)`; which `f` is meant depends on what is due here and, for overloads, on `x`."""
    name = dotted(call.function)
    if name is None:
        return checker.report("RL225", call.function.span, name=call.function.span.text)
    if name in _COUNTS:
        return _built_in(checker, call, name, context)
    verbs = [verb for verb in context.verbs if _has(checker, verb, name)]
    verbs = verbs[:1] or [verb for verb in _VERBS if _has(checker, verb, name)]
    if not verbs and context.verbs == () and name in checker.program.declarations:
        checker.use(name, context)
        return checker.report("RL226", call.function.span, name=name)
    if not verbs:
        return _no_function(checker, call, name, context)
    if len(verbs) == 1:
        return _of_kind(checker, call, verbs[0], name, context)
    return _overloaded(checker, call, verbs, name, context)


def dotted(expression: ast.Expression) -> str | None:
    """`acme.jerk` as one name; None if it is anything but names."""
    if isinstance(expression, ast.Name):
        return expression.text
    if isinstance(expression, ast.Member):
        inner = dotted(expression.of)
        return f"{inner}.{expression.name.text}" if inner else None
    return None


def _has(checker: Checker, verb: str, name: str) -> bool:
    return checker.registry.has(verb, name) or checker.registry.is_announced(verb, name)


def _no_function(checker: Checker, call: ast.Call, name: str, context: Context) -> Typed:
    span = call.function.span
    if context.verbs:
        find_kind(checker, context.verbs[0], name, span)
        return unknown(call.span)
    prefix = name.split(".")[0]
    broken = [found for found in checker.registry.broken if found.origin.plugin == prefix]
    if broken:
        plugin, reason = broken[0].origin, broken[0].reason
        checker.report("RL211", span, kind=name, plugin=plugin, reason=reason)
        return unknown(call.span)
    known = {entry.name for verb in _VERBS for entry in checker.registry.of(verb)}
    help_ = did_you_mean(name, known | set(_COUNTS))
    checker.report("RL225", span, name=name, help=help_)
    return unknown(call.span)


def _built_in(checker: Checker, call: ast.Call, name: str, context: Context) -> Typed:
    least, most = _COUNTS[name]
    count = len(call.arguments)
    if count < least or (most is not None and count > most):
        due = "two or more arguments" if most is None else "one argument"
        span = call.arguments[most].span if most and count > most else call.span
        return checker.report("RL224", span, name=name, help=f"`{name}` takes {due}")
    for argument in call.arguments:
        if argument.key is not None:
            return checker.report(
                "RL220", argument.key.span, name=argument.key.text, owner=f"`{name}`"
            )
    if name == "fresh":
        return _fresh(checker, call, context)
    arguments = [checker.infer(argument.value, context) for argument in call.arguments]
    if any(argument.is_unknown for argument in arguments):
        return unknown(call.span)
    for given in arguments:
        if not isinstance(given.type, Quantity | SignalType):
            what, found = f"`{name}`", given.type
            return checker.report("RL206", given.span, what=what, due="a number", found=found)
    dimension = common_dimension(checker, arguments, "compared")
    if dimension is None:
        return unknown(call.span)
    if all(isinstance(argument.type, Quantity) for argument in arguments):
        return of_functions(name, arguments, call.span, dimension)
    evidence = common_domain(checker, arguments)
    if evidence is None or isinstance(evidence, Typed):
        return unknown(call.span)
    from ..stl import Apply

    terms, numbers = terms_of(arguments)
    signals = tuple(dict.fromkeys(s for argument in arguments for s in argument.signals))
    return Typed(
        call.span,
        SignalType(evidence.domain, dimension),
        bounds=function_bounds(name, arguments),
        term=Apply(name, tuple(terms)),  # type: ignore[arg-type]
        evidence=evidence,
        signals=signals,
        numbers=numbers,
    )


def _fresh(checker: Checker, call: ast.Call, context: Context) -> Typed:
    value = call.arguments[0].value
    while isinstance(value, ast.Group):
        value = value.inner
    if not isinstance(value, ast.Name):
        return checker.report("RL232", value.span, what=value.span.text)
    typed = checker.infer(value, context)
    if typed.is_unknown:
        return typed
    declared = checker.program.declarations.get(value.text)
    if declared is None or declared.role not in ("param", "let") or not typed.random:
        return checker.report("RL232", value.span, what=value.text)
    again = checker.infer(expression_of(checker, value.text), replace(context, fresh=True))
    return replace(again, span=call.span, range=False)


def expression_of(checker: Checker, name: str) -> ast.Expression:
    """What a `param` or `let` is set to, here or from outside."""
    setting = checker.program.settings.get(name)
    if setting is not None:
        return setting.value
    statement = checker.program.declarations[name].statement
    assert isinstance(statement, ast.Param | ast.Let)
    return statement.value


def _of_kind(checker: Checker, call: ast.Call, verb: str, name: str, context: Context) -> Typed:
    found = find_kind(checker, verb, name, call.function.span)
    if found is None:
        return unknown(call.span)
    if verb == "drive_signal" and getattr(found.kind, "member", True):
        first = found.schema[0].name if found.schema else "agent"
        help_ = f"write `{first}.{name}`, as in `ego.{name}`"
        return checker.report("RL225", call.function.span, name=name, help=help_)
    inner = context if verb == "distribution" else replace(context, words=(), verbs=())
    rest = found.kind.rest
    bound = bind_arguments(checker, call, found.schema, rest, inner)
    if not bound.complete:
        return unknown(call.span)
    if verb == "distribution":
        return draw_of(checker, call, found, bound, context)
    if verb in ("signal", "drive_signal", "number"):
        return measured(checker, call.span, found, bound, name)
    random = any(typed.random for typed in bound.given.values())
    value = PassCall(verb, found.entry.qualified, bound.values, name, call.span)
    return Typed(call.span, CallType(verb), value, random)


def _overloaded(
    checker: Checker, call: ast.Call, verbs: list[str], name: str, context: Context
) -> Typed:
    """The one of several functions whose options take what the arguments name."""
    roles = [_role(checker, argument.value) for argument in call.arguments]
    if any(role == "unknown" for role in roles):
        for argument in call.arguments:
            checker.infer(argument.value, context)
        return unknown(call.span)
    candidates: list[tuple[str, Found]] = []
    for verb in verbs:
        found = find_kind(checker, verb, name, call.function.span)
        if found is not None:
            candidates.append((verb, found))
    for verb, found in candidates:
        if _takes(found.schema, roles) and not (
            issubclass(found.kind, DriveSignal) and found.kind.member
        ):
            return _of_kind(checker, call, verb, name, context)
    for argument in call.arguments:
        checker.infer(argument.value, context)
    takes = " or ".join(f"`{name}({_signature(found.schema)})`" for _, found in candidates)
    given = ", ".join(role or "a value" for role in roles)
    return checker.report("RL227", call.span, name=name, given=given, help=f"there is {takes}")


def _role(checker: Checker, value: ast.Expression) -> str | None:
    """The role of the thing an argument names; None for values."""
    while isinstance(value, ast.Group):
        value = value.inner
    if not isinstance(value, ast.Name):
        return None
    declared = checker.program.declarations.get(value.text)
    if declared is None or value.text in checker.program.spoiled:
        return "unknown"
    return declared.role if declared.role not in ("param", "let") else None


def _takes(schema: tuple[OptionSchema, ...], roles: list[str | None]) -> bool:
    for option, role in zip(schema, roles, strict=False):
        due = set(_roles_of(option))
        if (role is not None or due) and role not in due:
            return False
    return True


def _roles_of(option: OptionSchema) -> Iterable[str]:
    parts = option.type.alternatives if isinstance(option.type, UnionType) else (option.type,)
    return [role for part in parts if isinstance(part, EntityOption) for role in part.roles]


def _signature(schema: tuple[OptionSchema, ...]) -> str:
    return ", ".join(" or ".join(_roles_of(option)) or option.name for option in schema)


def infer_member(checker: Checker, member: ast.Member, context: Context) -> Typed:
    """`ego.speed`, `lead.start`, or a kind by its whole name, `acme.robot`."""
    parts = dotted(member)
    if parts is None:
        return checker.report("RL227", member.name.span, name=member.name.text, given="a call")
    base, _, name = parts.partition(".")
    declared = checker.program.declarations.get(base)
    if base in checker.program.spoiled:
        return unknown(member.span)
    if declared is None:
        return _no_such_base(checker, member, parts, base, context)
    root: ast.Expression = member
    while isinstance(root, ast.Member):
        root = root.of
    owner = checker.infer(root, context)
    if owner.is_unknown:
        return unknown(member.span)
    if not isinstance(owner.type, EntityType) or owner.type.role not in ("agent", "object"):
        return checker.report("RL233", member.name.span, name=base, found=owner.type, member=name)
    if name == "start":
        return _start(checker, member, base, owner.type.role)
    return _member_signal(checker, member, base, name, owner)


def _no_such_base(
    checker: Checker, member: ast.Member, parts: str, base: str, context: Context
) -> Typed:
    if checker.program.incomplete:
        return unknown(member.span)
    verbs = (*context.verbs, "agent", "object")
    for verb in verbs:
        if checker.registry.has(verb, parts):
            call = ast.Call(member, (), span=member.span)
            return _of_kind(checker, call, verb, parts, context)
    if context.verbs:
        find_kind(checker, context.verbs[0], parts, member.span)
        return unknown(member.span)
    span = member.of.span
    return checker.report("RL101", span, name=base, help=did_you_mean(
        base, checker.program.declarations))  # fmt: skip


def _start(checker: Checker, member: ast.Member, name: str, role: str) -> Typed:
    from ..ir.dimension import LENGTH

    statement = checker.program.declarations[name].statement
    assert isinstance(statement, ast.Actor)
    if statement.on is None:
        return checker.report("RL240", member.span, name=name)
    options = (("of", Entity(name, role)),)
    call = PassCall("placement", "start", options, f"{name}.start", member.span)
    return Typed(member.span, Quantity(LENGTH), Measure(call), random=True)


def _member_signal(
    checker: Checker, member: ast.Member, base: str, name: str, owner: Typed
) -> Typed:
    members = [entry for entry in checker.registry.of("drive_signal") if entry.name != "time"]
    if not checker.registry.has("drive_signal", name):
        if checker.registry.is_announced("drive_signal", name):
            find_kind(checker, "drive_signal", name, member.name.span)
            return unknown(member.span)
        known = [*(entry.name for entry in members), "start"]
        help_ = did_you_mean(name, known) or ("there are " + ", ".join(sorted(known)),)
        given = f"`{base}`"
        return checker.report("RL227", member.name.span, name=name, given=given, help=help_)
    found = find_kind(checker, "drive_signal", name, member.name.span)
    if found is None:
        return unknown(member.span)
    if not found.kind.member or len(found.schema) < 1:  # type: ignore[attr-defined]
        help_ = (f"it is written `{name}({_signature(found.schema)})`",)
        given = f"`{base}`"
        return checker.report("RL227", member.name.span, name=name, given=given, help=help_)
    first = found.schema[0]
    from .arguments import Bound
    from .fitting import fit

    fitted = fit(checker, owner, first)
    if fitted is None:
        return unknown(member.span)
    bound = Bound({first.name: fitted}, True)
    return measured(checker, member.span, found, bound, f"{base}.{name}", member=True)
