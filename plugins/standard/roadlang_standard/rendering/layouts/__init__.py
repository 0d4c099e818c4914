"""Plans: where the roads of a rendered scene lie."""
