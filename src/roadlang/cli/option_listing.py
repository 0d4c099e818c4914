"""Options and statements as `roadlang plugins show` and `roadlang explain` list them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .console import style

if TYPE_CHECKING:
    from ..plugins.options import OptionSchema
    from ..semantics.statement_reference import StatementReference


def option_lines(options: Iterable[OptionSchema], indent: str = "  ") -> list[str]:
    """Each option with its type, default, bounds and example, and its help below."""
    from ..plugins.describing import bounds_text, default_text, type_text

    lines = []
    for option in options:
        default = f"default {default_text(option)}" if option.default is not None else "optional"
        default = "required" if option.required else default
        example = f"for example {option.constraints.example}" if option.constraints.example else ""
        facts = [type_text(option), default, bounds_text(option), example]
        lines.append(f"\n{indent}{style(option.name, bold=True)}: {'; '.join(filter(None, facts))}")
        if option.help:
            lines.append(f"{indent}    {option.help}")
    return lines


def statement_lines(statement: StatementReference) -> list[str]:
    """A statement with its options, passes and an example."""
    lines = [f"{style(statement.form, bold=True)}", f"  {statement.help}"]
    lines += option_lines(statement.options)
    for verb, options in statement.passes.items():
        lines.append(f"\n  {style(f'{verb} with KIND', bold=True)}: see `roadlang plugins`")
        if options:
            lines.append(f"      every kind of `{verb}` also has:")
        lines += option_lines(options, "      ")
    if statement.example:
        lines += ["", "  example:", ""]
        lines += [f"    {line}" for line in statement.example.splitlines()]
    return lines
