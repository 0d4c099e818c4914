"""What the compiler says to its user: sources, spans, coded diagnostics, renderers."""

from .catalog import Page, UnknownCode, codes, page
from .code import Code
from .diagnostic import Diagnostic, Fix, Label, Severity, diagnose
from .errors import DiagnosticError
from .nearest import KnownNames, did_you_mean, nearest
from .source import Source, Span

__all__ = [
    "Code",
    "Diagnostic",
    "DiagnosticError",
    "Fix",
    "KnownNames",
    "Label",
    "Page",
    "Severity",
    "Source",
    "Span",
    "UnknownCode",
    "codes",
    "diagnose",
    "did_you_mean",
    "nearest",
    "page",
]
