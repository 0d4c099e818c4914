"""How vehicles move, and what they stand on."""
