"""The unit cube of all draws, in which samplers and searchers choose points."""

from __future__ import annotations

BELOW_ONE = 1.0 - 2.0**-53
"""The greatest coordinate: draws take numbers in [0, 1)."""
MOST_COMBINATIONS = 10_000_000
"""Points of a grid: more would take days."""
