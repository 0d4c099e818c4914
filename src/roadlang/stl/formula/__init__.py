"""Formulas and terms, how they are printed and rewritten."""
