"""Controllers that decide, at every step."""
