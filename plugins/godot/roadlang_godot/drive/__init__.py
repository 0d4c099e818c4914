"""Drives in the engine: freely, in lock-step, or decided for in Python."""
