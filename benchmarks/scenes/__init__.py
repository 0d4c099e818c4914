"""How fast accepted candidates become scenes and files."""
