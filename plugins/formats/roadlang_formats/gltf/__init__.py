"""Scenes as binary glTF."""
