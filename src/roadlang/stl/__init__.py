"""Signal temporal logic: formulas, robustness on batches of traces, ranges, explanations.

Importing this package imports neither numpy nor anything else heavy; each name comes with its
module when it is first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .foreign import read_breach, read_latex
    from .formulas import (
        Always,
        And,
        Comparison,
        Eventually,
        Formula,
        Historically,
        Iff,
        Implies,
        Not,
        Once,
        Or,
        Since,
        Truth,
        Until,
        Xor,
    )
    from .interval import UNBOUNDED, Interval
    from .json_form import from_json, to_json
    from .online import Monitor
    from .smooth import smooth_rho
    from .terms import Apply, Arithmetic, Constant, Negate, Term, Variable
    from .text import parse

_HOMES = {
    "formulas": (
        "Always And Comparison Eventually Formula Historically Iff Implies Not Once Or "
        "Since Truth Until Xor"
    ),
    "foreign": "read_breach read_latex",
    "interval": "Interval UNBOUNDED",
    "json_form": "from_json to_json",
    "online": "Monitor",
    "smooth": "smooth_rho",
    "terms": "Apply Arithmetic Constant Negate Term Variable",
    "text": "parse",
}
_HOME = {name: module for module, names in _HOMES.items() for name in names.split()}

__all__ = [
    "UNBOUNDED",
    "Always",
    "And",
    "Apply",
    "Arithmetic",
    "Comparison",
    "Constant",
    "Eventually",
    "Formula",
    "Historically",
    "Iff",
    "Implies",
    "Interval",
    "Monitor",
    "Negate",
    "Not",
    "Once",
    "Or",
    "Since",
    "Term",
    "Truth",
    "Until",
    "Variable",
    "Xor",
    "from_json",
    "parse",
    "read_breach",
    "read_latex",
    "smooth_rho",
    "to_json",
]


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return __all__
