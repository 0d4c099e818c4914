"""Formats of other tools: scenes as they read them."""
