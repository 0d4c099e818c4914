"""Godot engines as processes: found, started, watched, restarted."""
