"""Handles of a scene: their places, and how dragging one changes the text."""
