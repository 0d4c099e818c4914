"""Speed of the environments: `python -m benchmarks.envs`."""
