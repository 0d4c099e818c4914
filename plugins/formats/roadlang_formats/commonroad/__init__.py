"""Scenes as CommonRoad scenarios."""
