"""Stations along roads, and the passes that move them."""
