"""How high the parts of a road stand, in every backend that builds in space."""

CURB_HEIGHT = 0.12
"""Of a raised lane above the roadway, meters."""
PAINT_HEIGHT = 0.015
"""Of paint above the surface, meters, so that neither shines through the other."""
