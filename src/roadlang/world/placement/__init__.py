"""Where agents and objects stand, and the routes of agents."""
