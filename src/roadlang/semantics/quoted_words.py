"""Words without quotes among the values that a param may have: `choice(asphalt, wet)`."""

from __future__ import annotations

from ..syntax.tree import nodes as ast
from .names.program import Declaration


def word_help(declaration: Declaration | None, name: str) -> tuple[str, ...]:
    """Help for a name that a param chooses among its values and that may be meant as a word."""
    statement = None if declaration is None else declaration.statement
    if not isinstance(statement, ast.Param) or not isinstance(statement.value, ast.CallExpression):
        return ()
    chosen = [argument.value for argument in statement.value.arguments]
    is_chosen = any(isinstance(value, ast.Name) and value.text == name for value in chosen)
    return (f'a word is written in quotes here: `"{name}"`',) if is_chosen else ()
