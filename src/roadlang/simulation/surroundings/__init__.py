"""Who and what is around each agent, and what it touches."""
