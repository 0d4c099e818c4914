"""The client of the Godot engine: starts it, builds scenes in it, drives them, takes pictures."""
