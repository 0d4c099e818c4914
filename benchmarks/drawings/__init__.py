"""Drawn strokes with exact truth, and how straight and round their roads come out."""
