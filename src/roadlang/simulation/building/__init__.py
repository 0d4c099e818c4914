"""The world of some scenes at the start."""
