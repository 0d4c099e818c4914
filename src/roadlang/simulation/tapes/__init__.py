"""Computations of columns that are written down once and repeated, with numba or numpy."""
