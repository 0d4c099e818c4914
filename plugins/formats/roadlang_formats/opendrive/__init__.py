"""Scenes as ASAM OpenDRIVE."""
