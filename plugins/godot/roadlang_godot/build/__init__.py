"""What a scene is built from in the engine, as parts to send."""
