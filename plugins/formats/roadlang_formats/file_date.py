"""The date in files."""

DATE = "1970-01-01"
"""Formats demand one, and files of the same scene are to be equal."""
