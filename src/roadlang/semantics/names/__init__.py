"""Files, includes and declarations: what every name stands for."""
