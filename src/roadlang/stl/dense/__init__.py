"""Robustness between the samples: signals that are held or interpolated linearly."""
