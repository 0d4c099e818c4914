"""Picture files: opened with limits, their size, scale and place read from headers."""
