"""Roads of drawings, plans and masks."""
