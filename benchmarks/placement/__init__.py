"""Whether random scenes are placed right, and how long that takes."""
