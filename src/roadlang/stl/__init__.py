"""Signal temporal logic: formulas, robustness on batches of traces, ranges, explanations.

Importing this package imports neither numpy nor anything else heavy; each name comes with its
module when it is first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..diagnostics.renamed_names import current_name

if TYPE_CHECKING:
    from .dense.evaluation import dense_function, sampling_error
    from .dense.grids import OwnGrid
    from .evaluate.average_robustness import average_robustness
    from .evaluate.online import OnlineMonitor
    from .evaluate.smooth import smooth_rho
    from .evaluate.streaming import DecidedSample, StreamMonitor
    from .evaluate.time_robustness import time_robustness
    from .evaluate.verdicts import Range, Verdict
    from .evaluate.weighted_robustness import weighted_robustness
    from .explain.causes import ViolationInterval
    from .explain.explanation import Explanation, Link
    from .explain.mining import Mined, mine, mine_front
    from .explain.parameters import Parameter
    from .formats.breach_and_latex import read_breach, read_latex
    from .formats.json_form import from_json, to_json
    from .formats.staliro import read_staliro
    from .formats.text import parse
    from .formats.trace_files import read_trace
    from .formula.formulas import (
        Always,
        And,
        BinaryTemporal,
        Comparison,
        Connective,
        Count,
        Duration,
        Eventually,
        Fall,
        Formula,
        Historically,
        Iff,
        Implies,
        LogicalJunction,
        Next,
        Not,
        Once,
        Or,
        PastRelease,
        Prev,
        Release,
        Rise,
        SampleStep,
        Since,
        TemporalOperator,
        Truth,
        UnaryTemporal,
        Until,
        WeakSince,
        WeakUntil,
        Xor,
    )
    from .formula.interval import UNBOUNDED, Interval
    from .formula.normal_form import normal_form
    from .formula.terms import Apply, Arithmetic, Constant, Negate, Term, Variable

_HOMES = {
    "formula.formulas": (
        "Always And BinaryTemporal Comparison Connective Count Duration Eventually Fall Formula "
        "Historically Iff Implies LogicalJunction Next Not Once Or Prev Release Rise SampleStep "
        "Since TemporalOperator PastRelease Truth UnaryTemporal Until WeakSince WeakUntil Xor"
    ),
    "dense.evaluation": "dense_function sampling_error",
    "dense.grids": "OwnGrid",
    "explain.causes": "ViolationInterval",
    "explain.explanation": "Explanation Link",
    "formats.breach_and_latex": "read_breach read_latex",
    "formula.interval": "Interval UNBOUNDED",
    "formula.normal_form": "normal_form",
    "formats.json_form": "from_json to_json",
    "explain.mining": "Mined mine mine_front",
    "explain.parameters": "Parameter",
    "evaluate.average_robustness": "average_robustness",
    "evaluate.weighted_robustness": "weighted_robustness",
    "evaluate.online": "OnlineMonitor",
    "evaluate.smooth": "smooth_rho",
    "evaluate.streaming": "DecidedSample StreamMonitor",
    "evaluate.time_robustness": "time_robustness",
    "formula.terms": "Apply Arithmetic Constant Negate Term Variable",
    "formats.staliro": "read_staliro",
    "formats.text": "parse",
    "formats.trace_files": "read_trace",
    "evaluate.verdicts": "Range Verdict",
}
_HOME = {name: module for module, names in _HOMES.items() for name in names.split()}

__all__ = [
    "UNBOUNDED",
    "Always",
    "And",
    "Apply",
    "Arithmetic",
    "BinaryTemporal",
    "Comparison",
    "Connective",
    "Constant",
    "Count",
    "DecidedSample",
    "Duration",
    "Eventually",
    "Explanation",
    "Fall",
    "Formula",
    "Historically",
    "Iff",
    "Implies",
    "Interval",
    "Link",
    "LogicalJunction",
    "Mined",
    "Negate",
    "Next",
    "Not",
    "Once",
    "OnlineMonitor",
    "Or",
    "OwnGrid",
    "Parameter",
    "PastRelease",
    "Prev",
    "Range",
    "Release",
    "Rise",
    "SampleStep",
    "Since",
    "StreamMonitor",
    "TemporalOperator",
    "Term",
    "Truth",
    "UnaryTemporal",
    "Until",
    "Variable",
    "Verdict",
    "ViolationInterval",
    "WeakSince",
    "WeakUntil",
    "Xor",
    "average_robustness",
    "dense_function",
    "from_json",
    "mine",
    "mine_front",
    "normal_form",
    "parse",
    "read_breach",
    "read_latex",
    "read_staliro",
    "read_trace",
    "sampling_error",
    "smooth_rho",
    "time_robustness",
    "to_json",
    "weighted_robustness",
]


_RENAMED = {
    "Junction": "LogicalJunction",
    "Monitor": "OnlineMonitor",
    "Stretch": "ViolationInterval",
}


def __getattr__(name: str) -> object:
    name = current_name(__name__, name, _RENAMED)
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
