"""Routes through a road network by its lanes, and by the connections of its junctions."""
