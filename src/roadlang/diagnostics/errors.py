"""The exception that carries diagnostics to whoever reports them."""

from __future__ import annotations

from .diagnostic import Diagnostic
from .render import render_all


class DiagnosticError(Exception):
    """Raised for bad input, never for bugs. As text it is what the command line would print."""

    def __init__(self, *diagnostics: Diagnostic) -> None:
        super().__init__(*diagnostics)
        self.diagnostics = diagnostics

    def __str__(self) -> str:
        return render_all(self.diagnostics)
