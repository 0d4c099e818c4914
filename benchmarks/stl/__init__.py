"""Benchmarks of STL monitoring."""
