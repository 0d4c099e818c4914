"""Positions as text, time stamps of any clock included."""

from __future__ import annotations


def position_text(position: float) -> str:
    """Six significant digits; all that a double holds of large ones, such as 1700000001.2 for a
    time stamp that `1.7e+09` would not tell from its neighbors. Whole numbers stay whole, such as
    nanoseconds since 1970."""
    if 1e15 <= abs(position) < 1e19 and position == int(position):
        return str(int(position))
    return f"{position:.6g}" if abs(position) < 1e5 else f"{position:.15g}"
