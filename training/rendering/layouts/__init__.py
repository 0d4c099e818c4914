"""Road layouts that are rendered."""
