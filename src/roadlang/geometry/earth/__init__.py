"""Places on Earth: grids, projections, GeoJSON."""
