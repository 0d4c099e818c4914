"""The port on which Godot listens unless told otherwise: alone, for `roadlang --help` needs it."""

USUAL_PORT = 4242
