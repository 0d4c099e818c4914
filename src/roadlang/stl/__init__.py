"""Signal temporal logic: formulas, robustness on batches of traces, ranges, explanations.

Importing this package imports neither numpy nor anything else heavy; each name comes with its
module when it is first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .blame import Stretch
    from .explanation import Explanation, Link
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
    from .mining import Mined, Parameter, mine
    from .online import Monitor
    from .smooth import smooth_rho
    from .terms import Apply, Arithmetic, Constant, Negate, Term, Variable
    from .text import parse
    from .trace_files import read_trace
    from .verdicts import Range, Verdict

_HOMES = {
    "formulas": (
        "Always And Comparison Eventually Formula Historically Iff Implies Not Once Or "
        "Since Truth Until Xor"
    ),
    "blame": "Stretch",
    "explanation": "Explanation Link",
    "foreign": "read_breach read_latex",
    "interval": "Interval UNBOUNDED",
    "json_form": "from_json to_json",
    "mining": "Mined Parameter mine",
    "online": "Monitor",
    "smooth": "smooth_rho",
    "terms": "Apply Arithmetic Constant Negate Term Variable",
    "text": "parse",
    "trace_files": "read_trace",
    "verdicts": "Range Verdict",
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
    "Explanation",
    "Formula",
    "Historically",
    "Iff",
    "Implies",
    "Interval",
    "Link",
    "Mined",
    "Monitor",
    "Negate",
    "Not",
    "Once",
    "Or",
    "Parameter",
    "Range",
    "Since",
    "Stretch",
    "Term",
    "Truth",
    "Until",
    "Variable",
    "Verdict",
    "Xor",
    "from_json",
    "mine",
    "parse",
    "read_breach",
    "read_latex",
    "read_trace",
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
