extends RefCounted
## The materials of what moves.

const Looks := preload("../build/looks.gd")


static func body(paint: Color) -> StandardMaterial3D:
	var material := Looks.plain(paint, 0.3)
	material.metallic = 0.15
	return material


static func glass() -> StandardMaterial3D:
	return Looks.glass()


static func rubber() -> StandardMaterial3D:
	return Looks.plain(Color(0.025, 0.025, 0.03), 0.85)


static func trim() -> StandardMaterial3D:
	return Looks.plain(Color(0.06, 0.06, 0.07), 0.6)


static func metal() -> StandardMaterial3D:
	return Looks.plain(Color(0.55, 0.56, 0.58), 0.35)


static func skin() -> StandardMaterial3D:
	return Looks.plain(Color(0.72, 0.52, 0.4))


static func white() -> StandardMaterial3D:
	return Looks.plain(Color(0.85, 0.85, 0.84), 0.5)


## A lamp that shines, or would.
static func lamp(color: Color, energy: float) -> StandardMaterial3D:
	return Looks.glowing(color, energy)
