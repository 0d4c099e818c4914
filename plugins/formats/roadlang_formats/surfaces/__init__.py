"""The built roads and junctions of a scene as surfaces in space."""
