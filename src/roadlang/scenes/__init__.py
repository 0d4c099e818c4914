"""Accepted candidates to concrete scenes, and scenes to files."""
