"""Scenes in a Godot 4 engine: built over UDP, driven with physics, drawn, and edited live."""
