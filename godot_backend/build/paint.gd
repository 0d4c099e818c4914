extends "triangles.gd"
## What is painted on the road: stop lines, arrows, zebra crossings. Nothing touches it.

const Looks := preload("looks.gd")


func look() -> Material:
	return Looks.plain(Color(0.86, 0.86, 0.82), 0.8)
