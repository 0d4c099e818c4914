"""Scenes as models of MuJoCo."""
