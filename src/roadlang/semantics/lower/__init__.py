"""From the checked program to the scenario."""
