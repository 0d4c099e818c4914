"""Cross-sections of roads: lanes, their borders and paint."""
