"""What is allowed and probably not meant."""

from __future__ import annotations

from ...diagnostics import Code, Fix
from ...syntax.tree import nodes as ast
from ..checker import Checker


def warn(checker: Checker) -> None:
    """Unused names, names that a unit hides, agents and objects on roads that are not built,
    perturbations that end abruptly."""
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
    _warn_of_abrupt_intervals(checker)


def _warn_of_replaced_roads(checker: Checker) -> None:
    """Agents and objects on roads that are not built, since another is made from them."""
    derived: dict[str, str] = {}
    for declaration in checker.program.in_role("road"):
        statement = declaration.statement
        source = statement.source if isinstance(statement, ast.Geometry) else None
        if isinstance(source, ast.Name) and _is_road(checker, source.text):
            derived.setdefault(source.text, declaration.name.text)
    for declaration in checker.program.in_role("agent", "object"):
        statement = declaration.statement
        on = statement.on if isinstance(statement, ast.Actor) else None
        if isinstance(on, ast.Name) and on.text in derived:
            name, heir = declaration.name.text, derived[on.text]
            fixes = [Fix(on.span, heir)]
            checker.report(
                Code.ACTOR_ON_REPLACED_ROAD, on.span, name=name, road=on.text, heir=heir,
                help=f"place it on `{heir}`", fixes=fixes,
            )  # fmt: skip


def _is_road(checker: Checker, name: str) -> bool:
    declared = checker.program.declarations.get(name)
    return declared is not None and declared.role == "road"


def _warn_of_abrupt_intervals(checker: Checker) -> None:
    """Passes with `over` but without `taper`."""
    for declaration in checker.program.in_role("road", "network"):
        statement = declaration.statement
        block = statement.block if isinstance(statement, ast.Geometry) else None
        for call in block.passes if block else ():
            options = {item.key.text: item for item in call.block.options} if call.block else {}
            if call.verb.text != "perturb" or "over" not in options or "taper" in options:
                continue
            over = options["over"].span
            meant = f"{over.text}, taper: {_taper(options['over'].value)}"
            checker.report(
                Code.ABRUPT_INTERVAL, over, kind=call.kind.text,
                help=f"write `{meant}`", fixes=[Fix(over, meant)],
            )  # fmt: skip


def _taper(interval: ast.Expression) -> str:
    """10 m, or a quarter of an interval that is shorter than 40 m."""
    ends = interval.items if isinstance(interval, ast.ListValue) else ()
    numbers = [end for end in ends if isinstance(end, ast.NumberLiteral) and end.unit == "m"]
    if len(numbers) != 2:
        return "10m"
    quarter = (numbers[1].value - numbers[0].value) / 4
    return f"{quarter:g}m" if 0 < quarter < 10 else "10m"
