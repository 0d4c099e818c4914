"""What extractors find: roads between nodes, drawn from a graph."""
