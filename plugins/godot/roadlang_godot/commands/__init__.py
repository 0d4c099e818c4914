"""The commands `roadlang godot`, `roadlang render` and `roadlang watch`."""
