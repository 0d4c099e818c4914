"""Options, one by one, against the schema of a kind."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass, replace

from ...diagnostics import Code, Label, Span
from ...ir.read_only import FrozenDict
from ...ir.values import Entries, Items, Options
from ...plugins import option_types as opt
from ...plugins.options import OptionSchema, schema_of
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..suggestions import meant_name
from ..types import expression_types as ty
from ..types.assignable import check_assignable
from ..types.dimensions import common_dimension, dimension_of
from ..types.expression_types import TypedExpression
from .file_option import check_file
from .habits import option_help
from .legend import check_legend
from .options_elsewhere import kind_as_option, option_elsewhere
from .when_condition import check_condition


@dataclass(frozen=True, slots=True)
class BoundOptions:
    """The options that a block states and that fit. `complete`: no error was reported."""

    stated: dict[str, TypedExpression]
    complete: bool
    like: TypedExpression | None = None
    """One of the `Like` options, with the dimension that all of them have."""

    @property
    def values(self) -> Options:
        """What the IR keeps, in the order of the kind's fields."""
        return FrozenDict({
            name: typed.value for name, typed in self.stated.items() if typed.value is not None
        })  # fmt: skip

    @property
    def spans(self) -> FrozenDict[str, Span]:
        """Where the values are written."""
        return FrozenDict({name: typed.span for name, typed in self.stated.items()})


def divided(options: Options, names: Container[str]) -> tuple[Options, Options]:
    """The options of these names, and the others."""
    chosen = {name: value for name, value in options.items() if name in names}
    return FrozenDict(chosen), FrozenDict({n: v for n, v in options.items() if n not in chosen})


def bind_options(
    checker: Checker,
    options: Iterable[ast.Option],
    schema: Sequence[OptionSchema],
    context: Context,
    *,
    owner: str,
    span: Span,
    complete_block: bool = True,
    verbs: Iterable[str] = (),
) -> BoundOptions:
    """The options of a block. `complete_block`: it could be read, so that what is not in it is
    missing. `owner` has the options, for messages; `span` is blamed for what is missing. Kinds of
    the `verbs` may have options that it does not."""
    known = {option.name: option for option in schema}
    first: dict[str, Span] = {}
    stated: dict[str, TypedExpression] = {}
    misspelled: list[str] = []
    complete = True
    for option in options:
        name = option.key.text
        if name not in known:
            report_unknown(checker, option.key, known, owner, verbs)
            misspelled.append(name)
            complete = False
        elif name in first:
            labels = [Label(first[name], "given here first")]
            checker.report(Code.DUPLICATE_OPTION, option.key.span, labels=labels, name=name)
            complete = False
        else:
            first[name] = option.key.span
            typed = infer_option(checker, option.value, known[name], context)
            complete = typed is not None and complete
            if typed is not None:
                stated[name] = typed
    # An option that was misspelled is not missing as well.
    meant = {meant_name(name, known) for name in misspelled}
    written = {*first, *meant}
    missing = [o.name for o in schema if o.required and o.name not in written]
    if missing and complete_block:
        complete = report_missing(checker, owner, missing, known, span)
    return bound_of(checker, stated, schema, complete)


def infer_option(
    checker: Checker,
    value: ast.Expression,
    schema: OptionSchema,
    context: Context,
    *,
    argument: bool = False,
) -> TypedExpression | None:
    """The value of one option, or None, reported."""
    inner = context.for_option(schema.name, schema.type, schema.words, schema.constraints.example)
    if argument:
        # The draws of a call are numbered at its place, whatever its arguments are called.
        inner = replace(inner, place=context.place)
    match schema.type:
        case opt.ConditionType():
            return check_condition(checker, value, inner)
        case opt.RecordType(record):
            return _record(checker, value, schema, record, inner)
        case opt.ListType(opt.RecordType(record)) if isinstance(value, ast.ListValue):
            return _records(checker, value, schema, record, inner)
        case opt.FileType():
            return check_file(checker, value, schema, inner)
        case opt.MapType(opt.KindNameType(verb)):
            return check_legend(checker, value, schema, verb, inner)
    typed = checker.infer(value, inner)
    return check_assignable(checker, typed, schema)


def bound_of(
    checker: Checker,
    stated: dict[str, TypedExpression],
    schema: Sequence[OptionSchema],
    complete: bool,
) -> BoundOptions:
    """Options in the order of the schema, with their values, types and draws."""
    ordered = {option.name: stated[option.name] for option in schema if option.name in stated}
    numbers: list[TypedExpression] = []
    for option in schema:
        if option.name in ordered:
            numbers.extend(_comparable(ordered[option.name], option.type))
    if len(numbers) < 1:
        return BoundOptions(ordered, complete)
    dimension = common_dimension(checker, numbers, "used together")
    if dimension is None:
        return BoundOptions(ordered, False)
    leader = next((part for part in numbers if dimension_of(part) == dimension), numbers[0])
    return BoundOptions(ordered, complete, leader)


def _comparable(typed: TypedExpression, expected: opt.OptionType) -> list[TypedExpression]:
    if isinstance(expected, opt.LikeType) and isinstance(typed.type, ty.Quantity):
        return [typed]
    if isinstance(expected, opt.ListType | opt.IntervalType):
        return [part for item in typed.items for part in _comparable(item, expected.item)]
    return []


def report_unknown(
    checker: Checker,
    key: ast.Word,
    known: dict[str, OptionSchema],
    owner: str,
    verbs: Iterable[str] = (),
) -> None:
    """RL220, with where it belongs, the nearest option or all of them."""
    name = key.text
    habit = option_help(checker, name, owner, known) or kind_as_option(checker, name, verbs)
    meant = None if habit else meant_name(name, known)
    listed = "it has " + ", ".join(f"`{name}`" for name in known) if known else "it has none"
    help_ = habit or (() if meant else (*option_elsewhere(checker, name, verbs), listed))
    checker.report(Code.UNKNOWN_OPTION, key.span, name=name, owner=owner, help=help_, meant=meant)


def report_missing(
    checker: Checker,
    owner: str,
    missing: Sequence[str],
    known: dict[str, OptionSchema],
    span: Span,
    sort: str = "option",
    first: Sequence[str] = (),
) -> bool:
    """RL221, with help that comes `first` and what each of the missing is; always False."""
    from ..types.describe_option import describe

    names = ", ".join(f"`{name}`" for name in missing)
    help_ = [
        *first,
        *(
            f"`{name}`: {describe(known[name].type, known[name].words)}; {known[name].help}"
            for name in missing
        ),
    ]
    sort += "s" if len(missing) > 1 else ""
    checker.report(Code.MISSING_OPTION, span, owner=owner, names=names, sort=sort, help=help_)
    return False


def _record(
    checker: Checker, value: ast.Expression, schema: OptionSchema, record: type, context: Context
) -> TypedExpression | None:
    """The map against the options of the dataclass `record`."""
    if not isinstance(value, ast.MapValue):
        typed = checker.infer(value, context)
        if not typed.is_unknown:
            what = f"`{schema.name}`"
            checker.report(
                Code.WRONG_TYPE, typed.span, what=what, expected="a map", found=typed.type
            )
        return None
    options = [
        ast.Option(_word(entry.key), entry.value, span=entry.span) for entry in value.entries
    ]
    owner = f"`{schema.name}`"
    bound = bind_options(checker, options, schema_of(record), context, owner=owner, span=value.span)
    if not bound.complete:
        return None
    random = any(typed.random for typed in bound.stated.values())
    return TypedExpression(value.span, ty.MappingType(), Entries(bound.values), random)


def _records(
    checker: Checker, value: ast.ListValue, schema: OptionSchema, record: type, context: Context
) -> TypedExpression | None:
    """A list of maps, each with the options of the dataclass `record`."""
    found: list[TypedExpression] = []
    for number, item in enumerate(value.items):
        inner = replace(context, place=f"{context.place}/{number}")
        typed = _record(checker, item, schema, record, inner)
        if typed is not None:
            found.append(typed)
    if len(found) < len(value.items):
        return None
    values = Items(tuple(typed.value for typed in found if typed.value is not None))
    random = any(typed.random for typed in found)
    return TypedExpression(value.span, ty.SequenceType(), values, random, items=tuple(found))


def _word(key: ast.Word | ast.String) -> ast.Word:
    return key if isinstance(key, ast.Word) else ast.Word(key.value, span=key.span)
