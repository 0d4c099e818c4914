extends RefCounted
## Trees, one meter high and wide, standing on the ground.

const Looks := preload("../build/looks.gd")
const Solid := preload("solid.gd")

const BARK := Color(0.2, 0.15, 0.1)


## A conifer near the camera.
static func conifer(leaves: Color) -> Solid:
	var out := Solid.new()
	out.cylinder(Vector2(0.06, 0.045), 0.3, Vector3(0, 0.15, 0), Looks.plain(BARK))
	var tiers := [[0.3, 0.48, 0.3, 0.15], [0.52, 0.39, 0.28, 0.07], [0.71, 0.29, 0.26, 0.0]]
	for tier: Array in tiers:
		var look := Looks.plain(leaves.darkened(tier[3]))
		out.cylinder(
			Vector2(tier[1], 0.35 * tier[1]),
			tier[2],
			Vector3(0, tier[0], 0),
			look,
			Basis.IDENTITY,
			11
		)
	var top := Looks.plain(leaves.lightened(0.04))
	out.cylinder(Vector2(0.2, 0.0), 0.22, Vector3(0, 0.89, 0), top, Basis.IDENTITY, 11)
	return out


## A tree with a round crown.
static func broadleaf(leaves: Color) -> Solid:
	var out := Solid.new()
	out.cylinder(Vector2(0.055, 0.035), 0.45, Vector3(0, 0.22, 0), Looks.plain(BARK))
	var crowns := [
		[Vector3(0, 0.66, 0), 0.36, 0.0],
		[Vector3(0.17, 0.55, 0.1), 0.27, 0.08],
		[Vector3(-0.18, 0.57, 0.05), 0.27, 0.05],
		[Vector3(0.03, 0.56, -0.2), 0.26, 0.1],
		[Vector3(-0.02, 0.8, 0.03), 0.25, -0.05],
	]
	for crown: Array in crowns:
		var shade: float = crown[2]
		var look := Looks.plain(leaves.darkened(shade) if shade > 0.0 else leaves.lightened(-shade))
		out.ball(Vector3(1.0, 0.78, 1.0) * float(crown[1]), crown[0], look, 10)
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
