"""The outputs that a command line or a program names instead of the file's `emit`s."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose

if TYPE_CHECKING:
    from ..plugins.registry import Registry

_OPENING, _CLOSING = "{[(", "}])"


def parse_outputs(text: str) -> list[str]:
    """`json,svg{size: 800px}` as a list: the commas within brackets and quotes do not count."""
    parts, depth, quoted = [""], 0, False
    for character in text:
        quoted ^= character == '"'
        depth += not quoted and character in _OPENING
        depth -= not quoted and character in _CLOSING
        if character == "," and depth <= 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts if part.strip()]


def check_outputs(outputs: Sequence[str], registry: Registry) -> None:
    """Raises `DiagnosticError` RL930 for kinds that are not there, RL928 where there are none."""
    from ..plugins.finding import entry_of

    faults: list[Diagnostic] = []
    for text in outputs:
        name = text.replace("{", " ").split()[0]
        try:
            if not registry.is_planned("emit", name):
                entry_of(registry, "emit", name)
        except DiagnosticError as error:
            faults += error.diagnostics
    if not outputs:
        faults.append(diagnose(Code.NOTHING_TO_EMIT, help="for instance `--emit json,svg`"))
    if faults:
        raise DiagnosticError(*faults)
