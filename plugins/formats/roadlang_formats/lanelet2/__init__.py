"""Scenes as Lanelet2 maps."""
