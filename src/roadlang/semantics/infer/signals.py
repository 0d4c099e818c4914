"""Signals over roads and drives, and numbers of roads: dimension, domain, binding."""

from __future__ import annotations

from ...diagnostics import Code, Span
from ...ir.dimension import Dimension
from ...ir.values import Measure, PassCall, SignalBinding
from ...plugins.attribution import PluginFault, attributed
from ...plugins.kinds import Signal
from ...stl.formula.terms import Variable
from ..checker import Checker, ResolvedKind
from ..types.expression_types import DomainEvidence, Quantity, SignalType, TypedExpression, unknown
from ..types.number_terms import call_text
from .draws import constant_of
from .option_binding import BoundOptions

_DOMAINS = {"signal": "road", "drive_signal": "drive"}


def measured(
    checker: Checker,
    span: Span,
    found: ResolvedKind,
    bound: BoundOptions,
    name: str,
    *,
    member: bool = False,
) -> TypedExpression:
    """`curvature(bent)`, `ego.speed`: a signal; `length(bent)`: a number of the scene."""
    dimension = _dimension(checker, span, found, bound)
    if dimension is None:
        return unknown(span)
    verb = found.entry.verb
    text = name if member or not bound.values else call_text(name, bound.values)
    kind_name, values = found.entry.qualified, bound.values
    call = PassCall(verb, kind_name, values, text, span, option_spans=bound.spans)
    if verb == "number":
        kind = Quantity(dimension, is_integer=found.kind.is_integer)
        return TypedExpression(span, kind, Measure(call), random=True)
    domain = _DOMAINS[verb]
    return TypedExpression(
        span,
        SignalType(domain, dimension, found.kind.is_integer),
        term=Variable(text),
        evidence=DomainEvidence(domain, span, " ".join(span.text.split())),
        signals=(SignalBinding(text, call, dimension),),
    )


def _dimension(
    checker: Checker, span: Span, found: ResolvedKind, bound: BoundOptions
) -> Dimension | None:
    # What the dimension depends on (the p of d_p) has to be the same in every scene.
    constants = {name: constant_of(value) for name, value in bound.values.items()}
    known = {name: value for name, value in constants.items() if value is not None}
    for option in found.schema:
        if option.name not in bound.stated and not option.required:
            known.setdefault(option.name, option.default)
    try:
        with attributed():
            assert issubclass(found.kind, Signal)
            dimension = found.kind.dimension_of(known)
            if not isinstance(dimension, Dimension):
                raise TypeError(f"`dimension_of` gave {dimension!r}, not a Dimension")
    except PluginFault as fault:
        plugin, kind = found.entry.origin, found.entry.name
        checker.report(Code.BROKEN_PLUGIN, span, kind=kind, plugin=plugin, reason=fault)
        return None
    return dimension
