"""Options that are more than a value: conditions, files, kinds by name."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code, nearest
from ...ir.values import Entries, Text, Value
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..names.file_checks import file_fault
from ..types.assignable import fit
from ..types.expression_types import FlagType, FormulaType, MapType, TextType, Typed
from .conditions import condition_of, only_past
from .kinds import find_kind


def fit_condition(checker: Checker, value: ast.Expression, context: Context) -> Typed | None:
    """`when:` a formula over the drive that looks back only."""
    typed = checker.infer(value, replace(context, drive_time=True))
    if typed.is_unknown:
        return None
    if not isinstance(typed.type, FormulaType | FlagType):
        checker.report(
            Code.WRONG_TYPE, typed.span, what="`when`", due="a condition", found=typed.type
        )
        return None
    if typed.evidence is not None and typed.evidence.domain == "road":
        place = typed.evidence
        checker.report(
            Code.WRONG_DOMAIN, place.span, what="`when`", due="the drive", found="the road"
        )
        return None
    if not only_past(checker, value, typed):
        return None
    return replace(typed, value=condition_of(typed))


def fit_file(
    checker: Checker, value: ast.Expression, schema: OptionSchema, context: Context
) -> Typed | None:
    """A string that names a file, which must be there."""
    typed = fit(checker, checker.infer(value, context), schema)
    if typed is None or not isinstance(typed.type, TextType) or not typed.type.values:
        return typed
    declared = checker.program.declarations.get(context.user)
    folder = declared.folder if declared else checker.program.path.parent
    for name in sorted(typed.type.values):
        fault = file_fault(folder, name, typed.span, picture=False)
        if fault is not None:
            checker.diagnostics.append(fault)
            return None
    if isinstance(typed.value, Text):
        return replace(typed, value=Text(str(folder / typed.value.value)))
    return typed


def fit_kind_name(
    checker: Checker, value: ast.Expression, schema: OptionSchema, verb: str, context: Context
) -> Typed | None:
    """A map whose values are names of kinds, or words of the option: a legend."""
    if not isinstance(value, ast.MapValue):
        typed = checker.infer(value, context)
        if not typed.is_unknown:
            checker.report(
                Code.WRONG_TYPE, typed.span, what=f"`{schema.name}`", due="a map", found=typed.type
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
            due = f"a kind of {verb}"
            checker.report(
                Code.WRONG_TYPE, entry.value.span, what=f"`{key}`", due=due, found="a value"
            )
            complete = False
        else:
            if text not in schema.words:
                complete = _is_kind(checker, verb, text, entry.value, schema) and complete
            entries[key] = Text(text)
    if not complete:
        return None
    return Typed(value.span, MapType(), Entries(tuple(entries.items())))


def _is_kind(
    checker: Checker, verb: str, text: str, value: ast.Expression, schema: OptionSchema
) -> bool:
    known = checker.registry.has(verb, text) or checker.registry.is_planned(verb, text)
    if not known and (meant := nearest(text, schema.words)):
        checker.report(
            Code.UNKNOWN_KIND, value.span, name=text, noun=f"kind of {verb}", meant=meant
        )
        return False
    return find_kind(checker, verb, text, value.span) is not None


def kind_text(value: ast.Expression) -> str | None:
    """The dotted name that an expression is, if it is one; a string names as well."""
    if isinstance(value, ast.Name):
        return value.text
    if isinstance(value, ast.String):
        return value.value
    if isinstance(value, ast.Member) and isinstance(value.of, ast.Name):
        return f"{value.of.text}.{value.name.text}"
    return None
