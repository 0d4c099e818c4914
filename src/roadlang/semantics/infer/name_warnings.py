"""What is allowed and probably not meant."""

from __future__ import annotations

from ...diagnostics import Code, Fix
from ...syntax.tree import nodes as ast
from ..checker import Checker


def warn(checker: Checker) -> None:
    """Unused names, names that a unit hides, agents and objects on roads that are not built."""
    for declaration in checker.program.in_role("let"):
        name = declaration.name
        # A file that others include may well name more than each of them needs.
        in_main_file = name.span.source == checker.program.source
        if in_main_file and name.text not in checker.used:
            checker.report(Code.UNUSED_LET, name.span, name=name.text)
    for word, span in checker.divisors:
        if word in checker.program.declarations:
            checker.report(Code.UNIT_SHADOWS_NAME, span, name=word, text=span.text)
    _warn_of_replaced_roads(checker)


def _warn_of_replaced_roads(checker: Checker) -> None:
    """Agents and objects on roads that are not built, since another is made from them."""
    heirs: dict[str, str] = {}
    for declaration in checker.program.in_role("road"):
        statement = declaration.statement
        if isinstance(statement, ast.Geometry) and isinstance(statement.source, ast.Name):
            heirs.setdefault(statement.source.text, declaration.name.text)
    for declaration in checker.program.in_role("agent", "object"):
        statement = declaration.statement
        on = statement.on if isinstance(statement, ast.Actor) else None
        if isinstance(on, ast.Name) and on.text in heirs:
            name, heir = declaration.name.text, heirs[on.text]
            fixes = [Fix(on.span, heir)]
            checker.report(
                Code.ACTOR_ON_REPLACED_ROAD, on.span, name=name, road=on.text, heir=heir,
                help=f"place it on `{heir}`", fixes=fixes,
            )  # fmt: skip
