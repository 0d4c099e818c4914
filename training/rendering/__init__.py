"""Aerial pictures and drawings of roads with known truth, for training, examples and tests."""
