"""How far the embedded engine and Godot agree on the same scenes."""
