"""Benchmarks of the Godot backend."""
