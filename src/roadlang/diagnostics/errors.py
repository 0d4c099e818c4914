"""The exception that carries diagnostics to the code that reports them."""

from __future__ import annotations

from dataclasses import replace

from .diagnostic import Diagnostic
from .source import Span


class DiagnosticError(Exception):
    """Raised for bad input, never for bugs. As text it is what the command line would print.

    Raises `TypeError` for what is no diagnostic: plugins raise these too.
    """

    def __init__(self, *diagnostics: Diagnostic) -> None:
        if not diagnostics or not all(isinstance(item, Diagnostic) for item in diagnostics):
            raise TypeError("a DiagnosticError takes one or more diagnostics")
        super().__init__(*diagnostics)
        self.diagnostics = diagnostics

    @property
    def details(self) -> str:
        """What belongs below the diagnostics, such as a table; empty if nothing does."""
        return ""

    def at(self, span: Span | None) -> DiagnosticError:
        """The same, those without a place at this one."""
        return DiagnosticError(*(replace(d, span=d.span or span) for d in self.diagnostics))

    def __str__(self) -> str:
        from .render import render_all

        text = render_all(self.diagnostics)
        return f"{text}\n\n{self.details}" if self.details else text
