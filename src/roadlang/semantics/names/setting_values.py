"""A value of a `param` from outside; text without its quotes is reported as a whole, instead of
word by word as an expression."""

from __future__ import annotations

from collections.abc import Container

from ...diagnostics import Code, Diagnostic, Label, Source, diagnose
from ...syntax import parse_value
from ...syntax.tree import nodes as ast
from ..types.quoted_strings import unquoted_string
from .namespaces import Namespace, Unknown, resolved
from .program import Declaration

_OF_SEVERAL_WORDS = (
    ast.Member,
    ast.ArithmeticExpression,
    ast.NegateExpression,
    ast.ComparisonExpression,
    ast.Draw,
)
"""What `my-file.txt`, `a/b`, `a..b` and the like are as expressions, none of which is a string."""


def parsed_setting(
    source: Source, declaration: Declaration, space: Namespace, unknown: Unknown
) -> tuple[ast.Expression | None, list[Diagnostic]]:
    """The expression, or what is wrong with it. `space` and `unknown`: as of `resolved`."""
    parsed, found = parse_value(source)
    text = source.text.strip()
    is_text = isinstance(parsed, _OF_SEVERAL_WORDS) and not _is_included(parsed, space.aliases)
    is_faulty = parsed is None or any(each.is_error for each in found)
    if not _has_text(declaration) or '"' in text or not (is_faulty or is_text):
        if parsed is not None and not is_faulty:
            parsed = resolved(parsed, space, unknown)
        return parsed, found
    start = source.text.index(text)
    span = source.span(start, start + len(text))
    help_, fixes = unquoted_string(span)
    name = declaration.name
    return None, [
        diagnose(
            Code.WRONG_TYPE, span, labels=[Label(name.span, "its default is a string")],
            what=f"`{name.text}`", expected="a string", found="text without quotes",
            help=help_, fixes=fixes,
        )
    ]  # fmt: skip


def _is_included(parsed: ast.Expression | None, aliases: Container[str]) -> bool:
    """`left.word` of a file that is included as `left`."""
    return (
        isinstance(parsed, ast.Member)
        and isinstance(parsed.of, ast.Name)
        and parsed.of.text in aliases
    )


def _has_text(declaration: Declaration) -> bool:
    """Whether the default is a string, or one of several."""
    default = getattr(declaration.statement, "value", None)
    if isinstance(default, ast.CallExpression) and default.arguments:  # choice("a", "b")
        default = default.arguments[0].value
    return isinstance(default, ast.String | ast.Text)
