"""Scenes lit by one sun: single trees with trunks, limbs and crowns, and the shadows they throw."""
