"""Controllers and sensors of plugins, called in batches and guarded."""
