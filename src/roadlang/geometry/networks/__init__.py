"""Road networks: paths through them, cutting, clipping, correcting."""
