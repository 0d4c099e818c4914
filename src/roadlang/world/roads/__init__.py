"""Roads: drawn, read, selected or joined, then perturbed; points and lanes along them."""
