"""What the cameras of a scene see, and where everything is in their pictures."""
