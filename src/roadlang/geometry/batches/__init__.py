"""Many curves at once: displaced, compared, crossing."""
