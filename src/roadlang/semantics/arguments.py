"""Options and arguments, one by one, against the schema of a kind."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..diagnostics import Label, Span, nearest
from ..ir.values import Items, Value
from ..plugins import option_types as opt
from ..plugins.options import OptionSchema
from ..syntax import ast
from . import types as ty
from .checker import Checker
from .context import Context
from .fitting import fit
from .records import fit_record
from .special import fit_condition, fit_file, fit_kind_name
from .types import Typed
from .units import common_dimension, dimension_of


@dataclass(frozen=True, slots=True)
class Bound:
    """The options that were given and fit. `complete`: no error was reported on the way."""

    given: dict[str, Typed]
    complete: bool
    like: Typed | None = None
    """One of the `Like` options, with the dimension that all of them have."""

    @property
    def values(self) -> tuple[tuple[str, Value], ...]:
        """What the IR keeps, in the order of the kind's fields."""
        return tuple(
            (name, typed.value) for name, typed in self.given.items() if typed.value is not None
        )


def bind_options(
    checker: Checker,
    options: Iterable[ast.Option],
    schema: Sequence[OptionSchema],
    context: Context,
    *,
    owner: str,
    span: Span,
    whole: bool = True,
) -> Bound:
    """The options of a block. `whole`: the block could be read, so that what is not in it is
    missing. `owner` has the options, for messages; `span` is blamed for what is missing."""
    known = {option.name: option for option in schema}
    first: dict[str, Span] = {}
    given: dict[str, Typed] = {}
    misspelt: list[str] = []
    complete = True
    for option in options:
        name = option.key.text
        if name not in known:
            _report_unknown(checker, option.key, known, owner)
            misspelt.append(name)
            complete = False
        elif name in first:
            labels = [Label(first[name], "given here first")]
            checker.report("RL222", option.key.span, labels=labels, name=name)
            complete = False
        else:
            first[name] = option.key.span
            typed = infer_option(checker, option.value, known[name], context)
            complete = typed is not None and complete
            if typed is not None:
                given[name] = typed
    # An option that was misspelt is not missing as well.
    meant = {nearest(name, known) for name in misspelt}
    given_or_meant = {*first, *meant}
    missing = [o.name for o in schema if o.required and o.name not in given_or_meant]
    if missing and whole:
        complete = _report_missing(checker, owner, missing, known, span)
    return _bound(checker, given, schema, complete)


def bind_arguments(
    checker: Checker, call: ast.Call, schema: Sequence[OptionSchema], rest: str, context: Context
) -> Bound:
    """The arguments of a call: by position in the order of the fields, or by name."""
    known = {option.name: option for option in schema}
    owner = f"`{call.function.span.text}`"
    given: dict[str, Typed] = {}
    gathered: list[Typed] = []
    misspelt: list[str] = []
    complete = True
    slots = [option.name for option in schema if option.name != rest] if rest else list(known)
    for index, argument in enumerate(call.arguments):
        name = argument.key.text if argument.key else (rest or _slot(slots, index))
        if name is None:
            _report_count(checker, call, schema)
            return Bound(given, False)
        if name not in known:
            assert argument.key is not None
            _report_unknown(checker, argument.key, known, owner)
            misspelt.append(name)
            complete = False
            continue
        if name in given:
            checker.report("RL222", argument.span, name=name)
            complete = False
            continue
        if argument.key is None and rest:
            typed = infer_item(checker, argument.value, known[name], context)
        else:
            typed = infer_option(checker, argument.value, known[name], context, argument=True)
        complete = typed is not None and complete
        if typed is not None and argument.key is None and rest:
            gathered.append(typed)
        elif typed is not None:
            given[name] = typed
    positional = [argument for argument in call.arguments if argument.key is None]
    if gathered or (rest and positional):
        given[rest] = _gathered(call.span, gathered)
    named = {argument.key.text for argument in call.arguments if argument.key is not None}
    meant = {nearest(name, known) for name in misspelt}
    filled = {*given, *named, *meant, *([] if rest else slots[: len(positional)])}
    missing = [option.name for option in schema if option.required and option.name not in filled]
    if missing:
        complete = _report_missing(checker, owner, missing, known, call.span, "argument")
    return _bound(checker, given, schema, complete)


def infer_option(
    checker: Checker,
    value: ast.Expression,
    schema: OptionSchema,
    context: Context,
    *,
    argument: bool = False,
) -> Typed | None:
    """The value of one option, or None, reported."""
    inner = context.for_option(schema.name, schema.type, schema.words)
    if argument:
        # The draws of a call are numbered at its place, whatever its arguments are called.
        from dataclasses import replace

        inner = replace(inner, place=context.place)
    match schema.type:
        case opt.ConditionType():
            return fit_condition(checker, value, inner)
        case opt.RecordType(record):
            return fit_record(checker, value, schema, record, inner)
        case opt.FileType():
            return fit_file(checker, value, schema, inner)
        case opt.MapType(opt.KindNameType(verb)):
            return fit_kind_name(checker, value, schema, verb, inner)
    typed = checker.infer(value, inner)
    return fit(checker, typed, schema)


def infer_item(
    checker: Checker, value: ast.Expression, schema: OptionSchema, context: Context
) -> Typed | None:
    """One of the arguments that a list takes all of."""
    assert isinstance(schema.type, opt.ListType)
    item = OptionSchema(schema.name, schema.type.item, None, schema.constraints)
    typed = checker.infer(value, context)
    return fit(checker, typed, item)


def _slot(slots: Sequence[str], index: int) -> str | None:
    return slots[index] if index < len(slots) else None


def _gathered(span: Span, items: list[Typed]) -> Typed:
    values = tuple(item.value for item in items if item.value is not None)
    random = any(item.random for item in items)
    return Typed(span, ty.ListType(), Items(values), random, items=tuple(items))


def _bound(
    checker: Checker, given: dict[str, Typed], schema: Sequence[OptionSchema], complete: bool
) -> Bound:
    ordered = {option.name: given[option.name] for option in schema if option.name in given}
    alike: list[Typed] = []
    for option in schema:
        if option.name in ordered:
            alike.extend(_alike(ordered[option.name], option.type))
    if len(alike) < 1:
        return Bound(ordered, complete)
    dimension = common_dimension(checker, alike, "used together")
    if dimension is None:
        return Bound(ordered, False)
    leader = next((part for part in alike if dimension_of(part) == dimension), alike[0])
    return Bound(ordered, complete, leader)


def _alike(typed: Typed, due: opt.OptionType) -> list[Typed]:
    if isinstance(due, opt.LikeType) and isinstance(typed.type, ty.Quantity):
        return [typed]
    if isinstance(due, opt.ListType | opt.IntervalType):
        return [part for item in typed.items for part in _alike(item, due.item)]
    return []


def _report_unknown(
    checker: Checker, key: ast.Word, known: dict[str, OptionSchema], owner: str
) -> None:
    meant = nearest(key.text, known)
    listed = "it has " + ", ".join(f"`{name}`" for name in known) if known else "it has none"
    help_ = () if meant else (listed,)
    checker.report("RL220", key.span, name=key.text, owner=owner, help=help_, meant=meant)


def _report_missing(
    checker: Checker,
    owner: str,
    missing: Sequence[str],
    known: dict[str, OptionSchema],
    span: Span,
    sort: str = "option",
) -> bool:
    from .describing import describe

    names = ", ".join(f"`{name}`" for name in missing)
    help_ = [
        f"`{name}`: {describe(known[name].type, known[name].words)}; {known[name].help}"
        for name in missing
    ]
    checker.report("RL221", span, owner=owner, names=names, sort=sort, help=help_)
    return False


def _report_count(checker: Checker, call: ast.Call, schema: Sequence[OptionSchema]) -> None:
    names = ", ".join(option.name for option in schema)
    extra = call.arguments[len(schema)].span if len(call.arguments) > len(schema) else call.span
    name = call.function.span.text
    checker.report("RL224", extra, name=name, help=f"it is written `{name}({names})`")
