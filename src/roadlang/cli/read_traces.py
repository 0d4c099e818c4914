"""Traces that a command judges: each has samples."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose

if TYPE_CHECKING:
    from ..stl.formats.trace_files import Columns


_ABOUT_TRACES = frozenset((
    Code.EMPTY_TRACE, Code.INVALID_POSITIONS, Code.NON_FINITE_SIGNAL, Code.WRONG_SIGNAL_SHAPE,
    Code.MISSING_SIGNAL, Code.INVALID_WRAP_LENGTH, Code.NON_FINITE_TERM,
))  # fmt: skip
"""what only a trace can be at fault for: one of several, which has to be named"""


def read_samples(path: str, agent: str | None) -> Columns:
    """The columns of a file. Raises DiagnosticError RL340, RL300 with its name for no sample."""
    from ..stl.formats.trace_files import read_trace

    columns = read_trace(path, agent)
    if not columns[1]:
        lacks = "samples" if path.lower().endswith(".json") else "rows below its column names"
        help_ = f"{Path(path).name} has no {lacks}"
        raise DiagnosticError(diagnose(Code.EMPTY_TRACE, path=path, help=help_))
    return columns


def refuse_swapped(formula: str) -> None:
    """`click.UsageError` where the formula is the name of a file."""
    if Path(formula).suffix.lower() in (".csv", ".json") and os.path.exists(formula):
        raise click.UsageError(f"{formula} is a file: FORMULA comes first, then TRACE...")


@contextmanager
def judging(path: str, axis: str = "") -> Iterator[None]:
    """Around the evaluation of one trace: its diagnostics name the file. `axis`: the name of its
    first column."""
    try:
        yield
    except DiagnosticError as error:
        raise DiagnosticError(*naming(path, error.diagnostics, axis)) from error.__cause__


def naming(path: str, diagnostics: Iterable[Diagnostic], axis: str = "") -> Iterator[Diagnostic]:
    """Diagnostics with the file that those about a trace are about; where the first column, the
    `axis`, is taken for a signal, they say what it is."""
    for diagnostic in diagnostics:
        is_nowhere = diagnostic.span is None and diagnostic.path is None
        if is_nowhere and diagnostic.code in _ABOUT_TRACES:
            diagnostic = replace(diagnostic, path=path)
        if axis and diagnostic.code == Code.MISSING_SIGNAL and f"`{axis}`" in diagnostic.message:
            about = (
                f"`{axis}` is the first column, which is taken as the positions: put the time "
                "column first"
            )
            diagnostic = replace(diagnostic, help=(about, *diagnostic.help))
        yield diagnostic
