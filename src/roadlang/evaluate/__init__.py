"""The index of a scenario, batches of candidates, and the value of every expression for them."""
