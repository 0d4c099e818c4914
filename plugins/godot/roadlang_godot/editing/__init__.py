"""A scene that is changed while it drives: by its text, or by hand in the window."""
