extends RefCounted
## Meshes of the things beside the road, standing on the ground, their length along x.

const Looks := preload("../build/looks.gd")
const Solid := preload("solid.gd")
const TreeShape := preload("tree_shape.gd")
const HouseShape := preload("house_shape.gd")
const StreetFurniture := preload("street_furniture.gd")
const VehicleShapes := preload("vehicle_shapes.gd")

const PARKED := {
	"parked_car": Vector3(4.5, 1.5, 1.8),
	"parked_van": Vector3(5.9, 2.5, 2.0),
	"parked_truck": Vector3(9.0, 3.5, 2.5),
	"parked_bus": Vector3(12.0, 3.1, 2.55),
	"parked_bicycle": Vector3(1.8, 1.1, 0.6),
	"parked_motorcycle": Vector3(2.2, 1.2, 0.8),
}
const PAINTS: Array[Color] = [
	Color(0.42, 0.46, 0.5),
	Color(0.7, 0.71, 0.72),
	Color(0.12, 0.16, 0.24),
	Color(0.36, 0.1, 0.08),
	Color(0.16, 0.26, 0.18),
	Color(0.62, 0.57, 0.47),
]
const LEAVES: Array[Color] = [
	Color(0.12, 0.25, 0.09), Color(0.2, 0.31, 0.1), Color(0.15, 0.28, 0.12)
]
const MOST_KEPT := 512

static var _meshes: Dictionary = {}


## How many looks a sort has, where the scene names no color.
static func variants(sort: String) -> int:
	match sort:
		"tree":
			return LEAVES.size()
		"building", "house":
			return HouseShape.WALLS.size()
		_:
			return PAINTS.size() if PARKED.has(sort) else 1


## The size at which a sort is drawn that should be as large as `size`; instances are scaled.
static func drawn_size(sort: String, size: Vector3) -> Vector3:
	if sort == "building" or sort == "house":
		return size.round().max(Vector3.ONE * 2.0)
	return PARKED.get(sort, StreetFurniture.SIZES.get(sort, Vector3.ONE))


## The mesh of a sort; one that is not known is a plain box.
static func mesh(sort: String, color: String, size: Vector3, variant: int) -> ArrayMesh:
	var key := "%s %s %s %d" % [sort, color, size, variant]
	if not _meshes.has(key):
		if _meshes.size() >= MOST_KEPT:
			_meshes.clear()
		_meshes[key] = _made(sort, color, size, variant)
	return _meshes[key]


static func _made(sort: String, color: String, size: Vector3, variant: int) -> ArrayMesh:
	if PARKED.has(sort):
		var paint := _tint(color, PAINTS[variant % PAINTS.size()])
		var category := sort.trim_prefix("parked_")
		var wheelbase := size.x * (0.6 if category != "bicycle" else 0.58)
		return VehicleShapes.parked(category, size, wheelbase, paint)
	var furniture := StreetFurniture.solid_of(sort, _tint(color, Color(0.42, 0.43, 0.45)))
	if furniture != null:
		return furniture.mesh()
	var out := Solid.new()
	match sort:
		"tree":
			var leaves := _tint(color, LEAVES[variant % LEAVES.size()])
			out = TreeShape.broadleaf(leaves) if variant % 3 == 1 else TreeShape.conifer(leaves)
		"bush", "hedge":
			_add_bush(out, Looks.plain(_tint(color, Color(0.15, 0.25, 0.1))), sort == "hedge")
		"building", "house":
			var walls := HouseShape.WALLS
			out = HouseShape.house(size, _tint(color, walls[variant % walls.size()]), variant)
		"water":
			out.box(
				Vector3(1, 0.02, 1),
				Vector3.ZERO,
				Looks.plain(_tint(color, Color(0.06, 0.16, 0.22)), 0.05)
			)
		"rock":
			out.ball(
				Vector3(0.5, 0.5, 0.5),
				Vector3(0, 0.45, 0),
				Looks.plain(_tint(color, Color(0.33, 0.32, 0.31))),
				7
			)
		_:
			var usual := Color.from_hsv(float(sort.hash() % 360) / 360.0, 0.35, 0.6)
			out.box(Vector3.ONE, Vector3(0, 0.5, 0), Looks.plain(_tint(color, usual)))
	return out.mesh()


static func _add_bush(out: Solid, leaves: Material, is_hedge: bool) -> void:
	if is_hedge:
		out.box(Vector3(1, 0.96, 0.9), Vector3(0, 0.48, 0), leaves)
		return
	out.ball(Vector3(0.4, 0.42, 0.4), Vector3(0.02, 0.42, 0), leaves, 9)
	out.ball(Vector3(0.3, 0.32, 0.3), Vector3(0.2, 0.3, 0.16), leaves, 8)
	out.ball(Vector3(0.3, 0.3, 0.3), Vector3(-0.2, 0.3, -0.14), leaves, 8)


static func _tint(color: String, usual: Color) -> Color:
	# Paint in the open is never as pure as a color code.
	if color.is_empty():
		return usual
	return Color.from_string(color, usual).darkened(0.35).lerp(usual, 0.25)
