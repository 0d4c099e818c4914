extends RefCounted
## Trees, one meter high and wide, standing on the ground.

const Looks := preload("../build/looks.gd")
const Solid := preload("solid.gd")

const BARK := Color(0.2, 0.15, 0.1)


## A conifer near the camera.
static func conifer(leaves: Color) -> Solid:
	var out := Solid.new()
	out.cylinder(Vector2(0.06, 0.045), 0.3, Vector3(0, 0.15, 0), Looks.plain(BARK))
	_add_tier(out, 0.3, 0.48, 0.3, leaves.darkened(0.15))
	_add_tier(out, 0.52, 0.39, 0.28, leaves.darkened(0.07))
	_add_tier(out, 0.71, 0.29, 0.26, leaves)
	var top := Looks.plain(leaves.lightened(0.04))
	out.cylinder(Vector2(0.2, 0.0), 0.22, Vector3(0, 0.89, 0), top, Basis.IDENTITY, 11)
	return out


## A tree with a round crown.
static func broadleaf(leaves: Color) -> Solid:
	var out := Solid.new()
	out.cylinder(Vector2(0.055, 0.035), 0.45, Vector3(0, 0.22, 0), Looks.plain(BARK))
	_add_crown(out, Vector3(0, 0.66, 0), 0.36, leaves)
	_add_crown(out, Vector3(0.17, 0.55, 0.1), 0.27, leaves.darkened(0.08))
	_add_crown(out, Vector3(-0.18, 0.57, 0.05), 0.27, leaves.darkened(0.05))
	_add_crown(out, Vector3(0.03, 0.56, -0.2), 0.26, leaves.darkened(0.1))
	_add_crown(out, Vector3(-0.02, 0.8, 0.03), 0.25, leaves.lightened(0.05))
	return out


## Few triangles, for hundreds of trees on hills, down to the ground.
static func distant(is_round: bool) -> ArrayMesh:
	var out := Solid.new()
	if is_round:
		var look := Looks.plain(Color(0.13, 0.22, 0.08))
		out.cylinder(
			Vector2(0.07, 0.06), 0.3, Vector3(0, 0.15, 0), Looks.plain(BARK), Basis.IDENTITY, 5
		)
		out.ball(Vector3(0.42, 0.38, 0.42), Vector3(0, 0.6, 0), look, 6)
	else:
		var look := Looks.plain(Color(0.07, 0.16, 0.08))
		out.cylinder(Vector2(0.42, 0.0), 0.94, Vector3(0, 0.53, 0), look, Basis.IDENTITY, 6)
		out.cylinder(
			Vector2(0.07, 0.07), 0.2, Vector3(0, 0.05, 0), Looks.plain(BARK), Basis.IDENTITY, 5
		)
	return out.mesh()


static func _add_tier(out: Solid, height: float, radius: float, tall: float, leaves: Color) -> void:
	var radii := Vector2(radius, 0.35 * radius)
	out.cylinder(radii, tall, Vector3(0, height, 0), Looks.plain(leaves), Basis.IDENTITY, 11)


static func _add_crown(out: Solid, middle: Vector3, radius: float, leaves: Color) -> void:
	out.ball(Vector3(1.0, 0.78, 1.0) * radius, middle, Looks.plain(leaves), 10)
