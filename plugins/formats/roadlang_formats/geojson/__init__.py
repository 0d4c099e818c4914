"""Scenes as GeoJSON."""
