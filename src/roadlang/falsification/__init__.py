"""The search for scenes that violate an expectation: evaluation, grading, journal, statistics."""
