"""Maps whose values name kinds: the legend of a picture, `{ "T": tree, "#": road }`."""

from __future__ import annotations

from ...diagnostics import Code
from ...ir.read_only import FrozenDict
from ...ir.values import Entries, TextValue, Value
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..suggestions import meant_name
from ..types.expression_types import MappingType, TypedExpression
from .kinds import find_kind


def check_legend(
    checker: Checker, value: ast.Expression, schema: OptionSchema, verb: str, context: Context
) -> TypedExpression | None:
    """A map whose values are names of kinds, or words of the option: a legend."""
    if not isinstance(value, ast.MapValue):
        typed = checker.infer(value, context)
        if not typed.is_unknown:
            checker.report(
                Code.WRONG_TYPE,
                typed.span,
                what=f"`{schema.name}`",
                expected="a map",
                found=typed.type,
            )
        return None
    entries: dict[str, Value] = {}
    complete = True
    for entry in value.entries:
        key = entry.key.value if isinstance(entry.key, ast.String) else entry.key.text
        text = kind_text(entry.value)
        if key in entries:
            checker.report(Code.DUPLICATE_OPTION, entry.key.span, name=key)
            complete = False
        elif text is None:
            expected = f"a kind of {verb}"
            checker.report(
                Code.WRONG_TYPE,
                entry.value.span,
                what=f"`{key}`",
                expected=expected,
                found="a value",
            )
            complete = False
        else:
            if text not in schema.words:
                complete = _is_kind(checker, verb, text, entry.value, schema) and complete
            entries[key] = TextValue(text)
    if not complete:
        return None
    return TypedExpression(value.span, MappingType(), Entries(FrozenDict(entries)))


def _is_kind(
    checker: Checker, verb: str, text: str, value: ast.Expression, schema: OptionSchema
) -> bool:
    known = checker.registry.has(verb, text) or checker.registry.is_planned(verb, text)
    if not known and (meant := meant_name(text, schema.words)):
        checker.report(
            Code.UNKNOWN_KIND, value.span, name=text, noun=f"kind of {verb}", meant=meant
        )
        return False
    return find_kind(checker, verb, text, value.span) is not None


def kind_text(value: ast.Expression) -> str | None:
    """The dotted name that an expression is, if it is one; a string names as well."""
    if isinstance(value, ast.Name):
        return value.word
    if isinstance(value, ast.String):
        return value.value
    if isinstance(value, ast.Member) and isinstance(value.of, ast.Name):
        return f"{value.of.word}.{value.name.text}"
    return None
