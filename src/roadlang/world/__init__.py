"""What candidates describe: pictures, networks, roads, perturbation, signals, placement."""
