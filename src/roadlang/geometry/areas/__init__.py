"""Areas in the plane: rectangles, rings, triangles, levels."""
