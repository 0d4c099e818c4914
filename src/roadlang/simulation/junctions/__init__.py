"""Junctions along the lines of agents: crossings, stop lines, signals."""
