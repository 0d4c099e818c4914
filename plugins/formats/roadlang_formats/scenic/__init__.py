"""Scenes as programs of Scenic."""
