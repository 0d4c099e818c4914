"""The embedded engine: scenes driven in batches, without a simulator to install."""
