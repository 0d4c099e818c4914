"""Who goes first at junctions, and who has to wait where."""
