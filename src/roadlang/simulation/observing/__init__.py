"""What controllers see."""
