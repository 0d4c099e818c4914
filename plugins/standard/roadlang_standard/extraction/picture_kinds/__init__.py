"""What kind of picture it is: a photo, a map, a drawing, a mask."""
