"""The lines that agents follow."""
