"""Robustness of formulas on batches of traces, on parts of a trace, and its range."""
