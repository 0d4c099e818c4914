"""Speed of the embedded engine: `python -m benchmarks.drives`."""
