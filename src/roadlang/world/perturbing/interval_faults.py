"""Intervals of perturbations and surfaces that are not on their road."""

from __future__ import annotations

from ...diagnostics import Code, Diagnostic, Span, diagnose


def interval_off_road(
    span: Span | None, road: str, low: float, high: float, length: float | None = None
) -> Diagnostic:
    """RL414 for an interval `over: [low, high]`, meters; `length` of the road where it matters."""
    if low > high:
        reason = "it ends before it starts"
    elif length is None or low == high:
        # At most one station would move: a jump, or nothing.
        reason = "it has no length"
    else:
        reason = f"the road is {length:.1f}m long"
    return diagnose(
        Code.INTERVAL_OFF_ROAD, span, interval=f"[{low:g}m, {high:g}m]", road=road, reason=reason
    )
