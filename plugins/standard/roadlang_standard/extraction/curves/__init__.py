"""Smooth center lines: splines, fair curves, the edges of the road beside them."""
