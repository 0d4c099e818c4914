"""Scenarios, scenes, traces and what they are made of: frozen values in SI units."""
