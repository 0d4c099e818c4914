"""Blocks: passes with their kinds, and statements' own options."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...diagnostics import Code, Label, Span, nearest
from ...ir.read_only import FrozenDict
from ...ir.values import PassCall
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ...syntax.words import LABELED_PASS_VERBS, PASS_VERBS
from ..checker import Checker, ResolvedKind
from ..context import Context
from .kinds import display_name, find_kind
from .option_binding import BoundOptions, bind_options, divided
from .statement_spec import StatementSpec

_SOURCES = ("extract", "read", "draw")


def lower_passes(
    checker: Checker, spec: StatementSpec, block: ast.Block | None, context: Context
) -> tuple[PassCall, ...] | None:
    """The passes of a block in the order written; None where one of them is wrong."""
    calls: list[PassCall] = []
    counts: dict[str, int] = {}
    sources: list[ast.Pass] = []
    complete = True
    for item in block.passes if block else ():
        verb = item.verb.text
        if not _verb_fits(checker, spec, item):
            complete = False
            continue
        if verb in _SOURCES:
            sources.append(item)
            if len(sources) > 1:
                labels = [Label(sources[0].span, "the first one")]
                first = sources[0].verb.text
                checker.report(
                    Code.MULTIPLE_SOURCES, item.verb.span, labels=labels, first=first, second=verb
                )
                complete = False
        counts[verb] = counts.get(verb, 0) + 1
        place = f"{context.place}/{verb} {counts[verb]}"
        call = lower_pass(checker, item, spec, replace(context, place=place))
        complete = call is not None and complete
        if call is not None:
            calls.append(call)
    return tuple(calls) if complete else None


def _verb_fits(checker: Checker, spec: StatementSpec, item: ast.Pass) -> bool:
    verb = item.verb.text
    statement, verbs = spec.word, spec.verbs
    if verb in verbs:
        return True
    meant = nearest(verb, verbs)
    help_: list[str] = []
    if not meant and verbs:
        help_.append(f"`{statement}` takes " + ", ".join(f"`{known}`" for known in verbs))
    elif statement == "object" and verb in ("drive", "sense"):
        help_.append("objects do not move: only an `agent` drives and senses")
    code = Code.MISPLACED_PASS if verb in PASS_VERBS else Code.UNKNOWN_VERB
    checker.report(code, item.verb.span, what=f"`{statement}`", verb=verb, help=help_, meant=meant)
    return False


def lower_pass(
    checker: Checker, item: ast.Pass, spec: StatementSpec, context: Context
) -> PassCall | None:
    """`verb with kind { ... }`: the call, or None, reported."""
    verb = item.verb.text
    if item.label is not None and verb not in LABELED_PASS_VERBS:
        checker.report(Code.NAMED_PASS, item.label.span, verb=verb, name=item.label.text)
    found = find_kind(checker, verb, item.kind.text, item.kind.span)
    if found is None:
        return None
    common, context = spec.common_options(verb), replace(context, of_controller=verb == "drive")
    owner = f"`{display_name(verb, item.kind.text)}`"
    return lower_call(checker, found, item.block, common, context, owner, item.kind.span, item.span)


def lower_call(
    checker: Checker,
    found: ResolvedKind,
    block: ast.Block | None,
    common: Sequence[OptionSchema],
    context: Context,
    owner: str,
    fault_span: Span,
    span: Span,
) -> PassCall | None:
    """The options of a kind, and of its verb, against their schema."""
    names = {option.name for option in found.schema}
    schema = [*found.schema, *(option for option in common if option.name not in names)]
    bound = bind_options(
        checker,
        block.options if block else (),
        schema,
        context,
        owner=owner,
        span=fault_span,
        complete_block=_is_complete(block),
        verbs=(found.entry.verb,),
    )
    for inner in block.passes if block else ():
        checker.report(Code.MISPLACED_PASS, inner.verb.span, what=owner, verb=inner.verb.text)
    if not bound.complete or (block is not None and (block.passes or not block.complete)):
        return None
    options, rest = divided(bound.values, names)
    verb, kind = found.entry.verb, found.entry.qualified
    return PassCall(verb, kind, options, context.place, span, rest, bound.spans)


def lower_options(
    checker: Checker,
    spec: StatementSpec,
    block: ast.Block | None,
    context: Context,
    span: Span,
    extra: Sequence[OptionSchema] = (),
) -> BoundOptions:
    """The options of a statement, and those that its kind has beside them."""
    return bind_options(
        checker,
        block.options if block else (),
        [*spec.schema, *extra],
        context,
        owner=f"`{spec.word}`",
        span=span,
        complete_block=_is_complete(block),
        verbs=spec.verbs,
    )


def value_spans(block: ast.Block | None) -> FrozenDict[str, Span]:
    """Where the values of the options are written, and the members of lists: `route 0`."""
    options = block.options if block else ()
    spans = {option.key.text: option.value.span for option in options}
    for option in options:
        if isinstance(option.value, ast.ListValue):
            members = enumerate(option.value.items)
            spans |= {f"{option.key.text} {place}": item.span for place, item in members}
    return FrozenDict(spans)


def _is_complete(block: ast.Block | None) -> bool:
    """Whether what is not in a block is missing, rather than in a part that could not be read."""
    return block is None or (block.complete and block.span.text.endswith("}"))
