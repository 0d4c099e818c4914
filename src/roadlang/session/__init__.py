"""The front door: load a scene file, sample scenes, emit or drive them. `roadlang` exports it."""
