"""Roads drawn on paper and photographed."""
