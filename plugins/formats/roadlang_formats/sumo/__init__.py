"""Scenes as networks, routes and configurations of SUMO."""
