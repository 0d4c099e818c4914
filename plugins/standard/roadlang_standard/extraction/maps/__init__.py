"""Roads of rendered maps."""
