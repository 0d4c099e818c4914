"""Kinds and their options, hooks, discovery, the registry. Only here is pluggy."""
