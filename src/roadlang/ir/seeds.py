"""Seeds of random numbers, which outputs record."""

LARGEST_SEED = 2**63 - 1
"""What the integers of JSON readers and of MessagePack can hold."""
