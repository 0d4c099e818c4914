"""Skeletons as graphs: traced, tidied, dead ends extended and linked."""
