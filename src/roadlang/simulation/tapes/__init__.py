"""Computations of columns that are written down once and repeated by a compiled loop."""
