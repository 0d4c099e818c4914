"""Masks: connected parts, growing, thinning, two thresholds."""
