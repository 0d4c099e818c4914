"""What a human can take hold of in a scene: where it is, and how a move changes the text."""
