"""Lanes of roads as tables, and what they are made of."""
