"""Curves by arc length, and what is made of single lines."""
