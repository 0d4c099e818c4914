"""Aerial-looking pictures with exact truth: scenes are planned, painted and photographed."""
