"""When vehicles have room enough in bends. The start speeds of scenes, the lines of long vehicles
and the rule of who waits for whom agree on it."""

from __future__ import annotations

LONG = 7.0
"""Meters: shorter vehicles have room enough in their lanes."""
STRAIGHT = 0.004
"""1/m: bends with less curvature do not matter."""
PASSING_GAP = 0.3
"""Meters between two that pass each other."""
BRAKING = 3.0
"""m/s^2: the hardest braking of an agent that waits for another one before a bend."""
