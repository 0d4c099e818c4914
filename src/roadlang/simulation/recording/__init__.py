"""What is recorded of drives."""
