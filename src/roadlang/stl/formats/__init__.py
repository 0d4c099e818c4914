"""Formulas and traces read from and written to text, JSON, CSV and other tools' notations."""
