"""The search for scenes: samplers, batches of attempts, workers, statistics of rejection."""
