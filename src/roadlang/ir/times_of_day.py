"""Times of day by name."""

from __future__ import annotations

from types import MappingProxyType

_HOUR = 3600.0
TIMES_OF_DAY = MappingProxyType({
    "night": 0.0,
    "dawn": 6 * _HOUR,
    "morning": 9 * _HOUR,
    "noon": 12 * _HOUR,
    "day": 12 * _HOUR,
    "afternoon": 15 * _HOUR,
    "dusk": 18 * _HOUR,
    "evening": 20 * _HOUR,
})  # fmt: skip
"""Seconds since midnight. The sun of engines rises at six and sets at eighteen."""
