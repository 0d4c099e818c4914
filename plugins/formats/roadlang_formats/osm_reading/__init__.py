"""Extracts of OpenStreetMap read: their ways, and the network of those that vehicles use."""
