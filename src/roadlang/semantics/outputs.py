"""Outputs that are named from outside (`--emit`), in the place of the file's `emit`s."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..diagnostics import Code, Diagnostic, Source
from ..ir.values import PassCall
from ..syntax import parse
from ..syntax.tree import nodes as ast
from .names.program import Program

LABEL = "--emit"
"""What diagnostics call the place of an output that is named from outside."""


def add_outputs(program: Program, outputs: Sequence[str]) -> None:
    """Have each output checked like an `emit` statement: `svg`, or `svg { size: 800px }`.

    One without options that the file emits as well means what the file says.
    """
    for text in outputs:
        if text in _emitted(program):
            continue
        source = _source(text)
        tree, found = parse(source)
        program.diagnostics.extend(found)
        for statement in tree.statements:
            if isinstance(statement, ast.Emit):
                program.add_unnamed(statement, program.path.parent)


def select_outputs(emits: Sequence[PassCall], outputs: Sequence[str]) -> tuple[PassCall, ...]:
    """Of all that was lowered, what `outputs` name, in their order."""
    chosen: list[PassCall] = []
    for text in outputs:
        from_file = [call for call in emits if not _is_from_outside(call) and _names(call, text)]
        added = [c for c in emits if c.span is not None and c.span.source == _source(text)]
        chosen += from_file or added
    return tuple(dict.fromkeys(chosen))


def with_advice(found: Diagnostic) -> Diagnostic:
    """Where an option of an output from outside is missing: how it can be said."""
    from_outside = found.span is not None and found.span.source.path == LABEL
    if not from_outside or found.code != Code.MISSING_OPTION:
        return found
    kind = found.span.text if found.span is not None else ""
    advice = (
        f"write `{LABEL} '{kind}{{option: value}}'`, or `emit {kind} {{ ... }}` in the file: "
        f"`{LABEL} {kind}` then has its options"
    )
    return replace(found, help=(*found.help, advice))


def _source(text: str) -> Source:
    # On one line, so that it is one statement.
    return Source(LABEL, f"emit {' '.join(text.split())}")


def _emitted(program: Program) -> set[str]:
    statements = (placed.statement for placed in program.unnamed)
    return {s.kind.text for s in statements if isinstance(s, ast.Emit)}


def _is_from_outside(call: PassCall) -> bool:
    return call.span is not None and call.span.source.path == LABEL


def _names(call: PassCall, text: str) -> bool:
    return text in (call.kind, call.kind.rpartition(".")[2])
