"""Random networks, and checks of the junctions planned for them."""
