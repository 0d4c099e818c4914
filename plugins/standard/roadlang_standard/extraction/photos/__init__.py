"""Roads of photos from above, by neural networks and by ribbons."""
