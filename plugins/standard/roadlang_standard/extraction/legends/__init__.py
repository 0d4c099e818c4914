"""Pictures and texts with a legend: cells, colors, objects."""
