"""Types, dimensions, bounds of values, and what can be assigned to what."""
