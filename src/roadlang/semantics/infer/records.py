"""Options that are maps with keys of their own: `sun: { azimuth: 90deg }`."""

from __future__ import annotations

from ...diagnostics import Code
from ...ir.values import Entries
from ...plugins.options import OptionSchema, schema_of
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..types.expression_types import MapType, Typed


def fit_record(
    checker: Checker, value: ast.Expression, schema: OptionSchema, record: type, context: Context
) -> Typed | None:
    """The map against the options of the dataclass `record`."""
    from .option_binding import bind_options

    if not isinstance(value, ast.MapValue):
        typed = checker.infer(value, context)
        if not typed.is_unknown:
            what = f"`{schema.name}`"
            checker.report(Code.WRONG_TYPE, typed.span, what=what, due="a map", found=typed.type)
        return None
    options = [
        ast.Option(_word(entry.key), entry.value, span=entry.span) for entry in value.entries
    ]
    owner = f"`{schema.name}`"
    bound = bind_options(checker, options, schema_of(record), context, owner=owner, span=value.span)
    if not bound.complete:
        return None
    random = any(typed.random for typed in bound.given.values())
    return Typed(value.span, MapType(), Entries(bound.values), random)


def _word(key: ast.Word | ast.String) -> ast.Word:
    return key if isinstance(key, ast.Word) else ast.Word(key.value, span=key.span)
