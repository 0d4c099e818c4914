"""Signals with a similar name that have the dimension a formula needs."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from ...ir.dimension import Dimension
from ...ir.units import parse_unit
from ...plugins.attribution import PluginFault, attributed
from ...plugins.kinds import Signal
from ...plugins.registry import KindEntry
from ..checker import Checker
from .expression_types import TypedExpression


def similar_signals(
    checker: Checker, part: TypedExpression, other: TypedExpression, needed: Dimension
) -> tuple[str, ...]:
    """For `ego.progress` beside a length: ``("`ego.route_progress` is a length",)``."""
    text = part.span.text.strip()
    if len(part.signals) != 1 or part.signals[0].variable != text or "(" in text:
        return ()
    call = part.signals[0].call
    owner, _, name = text.rpartition(".")
    entries = checker.registry.of(call.verb)
    similar = [e for e in entries if e.name != name and (e.name in name or name in e.name)]
    names = (f"{owner}.{found}" for found in _of_dimension(similar, needed))
    return tuple(f"`{name}` is {needed}" for name in names if name != other.span.text)


def _of_dimension(entries: list[KindEntry], needed: Dimension) -> Iterator[str]:
    """The names of those that are members; what is wrong with a kind is said where it is used."""
    for entry in entries:
        with suppress(PluginFault), attributed():
            kind = entry.load()
            if issubclass(kind, Signal) and kind.member and _dimension(kind) == needed:
                yield entry.name


def _dimension(kind: type[Signal]) -> Dimension:
    return parse_unit(kind.unit).dimension
