"""Intervals of perturbations that are not on their road."""

from __future__ import annotations

from ..diagnostics import Code, Diagnostic, diagnose
from ..ir.values import PassCall


def interval_off_road(
    call: PassCall, road: str, low: float, high: float, length: float | None = None
) -> Diagnostic:
    """RL414 for an interval `over: [low, high]`, meters; `length` of the road where it matters."""
    # Of an interval without length at most one station would move: a jump, or nothing.
    reason = "it has no length" if low == high else f"the road is {length:.1f}m long"
    return diagnose(
        Code.INTERVAL_OFF_ROAD,
        call.option_spans.get("over", call.span),
        interval=f"[{low:g}m, {high:g}m]",
        road=road,
        reason=reason,
    )
