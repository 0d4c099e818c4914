"""Drives: the contract of controllers, traces as files, and judging by them."""
