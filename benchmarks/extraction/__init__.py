"""Benchmarks of road extraction."""
