extends RefCounted
## Meshes of things beside the road, one meter each way, standing on the ground.

const Looks := preload("looks.gd")

const WALLS: Array[Color] = [
	Color(0.76, 0.71, 0.62), Color(0.66, 0.5, 0.42), Color(0.7, 0.72, 0.74), Color(0.8, 0.76, 0.66)
]

static var _meshes: Dictionary = {}


## The mesh of a sort of object; one that is not known is a plain box.
static func mesh(sort: String, color: String) -> ArrayMesh:
	var key := "%s %s" % [sort, color]
	if not _meshes.has(key):
		_meshes[key] = _made(sort, color)
	return _meshes[key]


static func _made(sort: String, color: String) -> ArrayMesh:
	match sort:
		"tree":
			return _tree(_tint(color, Color(0.16, 0.3, 0.1)))
		"bush", "hedge":
			return _bush(_tint(color, Color(0.2, 0.34, 0.13)))
		"building", "house":
			return _building(_tint(color, WALLS[0]))
		"parked_van", "parked_car", "van":
			return _van(_tint(color, Color(0.85, 0.86, 0.88)))
		"lamp", "pole", "sign":
			return _pole(_tint(color, Color(0.35, 0.36, 0.38)))
		"cone":
			return _cone(_tint(color, Color(0.9, 0.35, 0.05)))
		"water":
			return _slab(Looks.plain(_tint(color, Color(0.1, 0.24, 0.32)), 0.05))
		_:
			return _box(_tint(color, Color.from_hsv(_hue(sort), 0.35, 0.6)))


static func _tint(color: String, usual: Color) -> Color:
	# Paint in the open is never as pure as a color code.
	return (
		usual
		if color.is_empty()
		else Color.from_string(color, usual).darkened(0.4).lerp(usual, 0.3)
	)


static func _hue(sort: String) -> float:
	return float(sort.hash() % 360) / 360.0


static func _tree(leaves: Color) -> ArrayMesh:
	var out: Array[Array] = []
	_add(out, _cylinder(0.05, 0.07, 0.3), Vector3(0, 0.15, 0), Looks.plain(Color(0.3, 0.22, 0.15)))
	_add(out, _cylinder(0.16, 0.5, 0.42), Vector3(0, 0.41, 0), Looks.plain(leaves.darkened(0.15)))
	_add(out, _cylinder(0.1, 0.4, 0.36), Vector3(0, 0.63, 0), Looks.plain(leaves))
	_add(out, _cylinder(0.0, 0.27, 0.3), Vector3(0, 0.85, 0), Looks.plain(leaves.lightened(0.08)))
	return _joined(out)


static func _bush(leaves: Color) -> ArrayMesh:
	var out: Array[Array] = []
	var ball := SphereMesh.new()
	ball.radius = 0.5
	ball.height = 1.0
	ball.radial_segments = 10
	ball.rings = 6
	_add(out, ball, Vector3(0, 0.4, 0), Looks.plain(leaves))
	return _joined(out)


static func _building(wall: Color) -> ArrayMesh:
	var out: Array[Array] = []
	_add(out, _cuboid(Vector3(1, 0.94, 1)), Vector3(0, 0.47, 0), Looks.plain(wall))
	var window := Looks.glass()
	for row in 3:
		var y := 0.2 + row * 0.27
		_add(out, _cuboid(Vector3(1.004, 0.12, 0.8)), Vector3(0, y, 0), window)
		_add(out, _cuboid(Vector3(0.8, 0.12, 1.004)), Vector3(0, y, 0), window)
	for column in 5:
		var at := -0.4 + column * 0.2
		_add(out, _cuboid(Vector3(1.01, 0.9, 0.05)), Vector3(0, 0.46, at), Looks.plain(wall))
		_add(out, _cuboid(Vector3(0.05, 0.9, 1.01)), Vector3(at, 0.46, 0), Looks.plain(wall))
	var roof := Looks.plain(Color(0.33, 0.3, 0.3))
	_add(out, _cuboid(Vector3(1.04, 0.06, 1.04)), Vector3(0, 0.97, 0), roof)
	return _joined(out)


static func _van(paint: Color) -> ArrayMesh:
	var out: Array[Array] = []
	var body := Looks.plain(paint, 0.35)
	var tire := Looks.plain(Color(0.05, 0.05, 0.05))
	_add(out, _cuboid(Vector3(1, 0.7, 1)), Vector3(0, 0.5, 0), body)
	_add(out, _cuboid(Vector3(0.82, 0.25, 0.94)), Vector3(-0.06, 0.87, 0), body)
	_add(out, _cuboid(Vector3(0.83, 0.2, 0.86)), Vector3(-0.055, 0.86, 0), Looks.glass())
	_add(out, _cuboid(Vector3(0.74, 0.2, 0.95)), Vector3(-0.07, 0.86, 0), Looks.glass())
	for x: float in [-0.3, 0.3]:
		_add(out, _cuboid(Vector3(0.16, 0.32, 1.01)), Vector3(x, 0.16, 0), tire)
	return _joined(out)


static func _pole(metal: Color) -> ArrayMesh:
	var out: Array[Array] = []
	_add(out, _cylinder(0.2, 0.3, 0.95), Vector3(0, 0.475, 0), Looks.plain(metal, 0.5))
	_add(out, _cuboid(Vector3(1, 0.05, 0.6)), Vector3(0, 0.97, 0), Looks.plain(metal, 0.5))
	return _joined(out)


static func _cone(orange: Color) -> ArrayMesh:
	var out: Array[Array] = []
	_add(out, _cuboid(Vector3(1, 0.06, 1)), Vector3(0, 0.03, 0), Looks.plain(orange))
	_add(out, _cylinder(0.06, 0.34, 0.94), Vector3(0, 0.53, 0), Looks.plain(orange))
	return _joined(out)


static func _slab(material: Material) -> ArrayMesh:
	var out: Array[Array] = []
	_add(out, _cuboid(Vector3(1, 0.02, 1)), Vector3(0, 0.0, 0), material)
	return _joined(out)


static func _box(color: Color) -> ArrayMesh:
	var out: Array[Array] = []
	_add(out, _cuboid(Vector3.ONE), Vector3(0, 0.5, 0), Looks.plain(color))
	return _joined(out)


static func _cuboid(size: Vector3) -> BoxMesh:
	var box := BoxMesh.new()
	box.size = size
	return box


static func _cylinder(top: float, bottom: float, height: float) -> CylinderMesh:
	var cylinder := CylinderMesh.new()
	cylinder.top_radius = top
	cylinder.bottom_radius = bottom
	cylinder.height = height
	cylinder.radial_segments = 9
	cylinder.rings = 1
	return cylinder


## Adds a part, moved to its place.
static func _add(parts: Array[Array], part: PrimitiveMesh, at: Vector3, look: Material) -> void:
	parts.append([part, at, look])


## One mesh of all parts; those of one material become one surface.
static func _joined(parts: Array[Array]) -> ArrayMesh:
	var tools: Dictionary = {}
	for part in parts:
		if not tools.has(part[2]):
			tools[part[2]] = SurfaceTool.new()
		var tool: SurfaceTool = tools[part[2]]
		var primitive: PrimitiveMesh = part[0]
		tool.append_from(primitive, 0, Transform3D(Basis.IDENTITY, part[1]))
	var mesh_made := ArrayMesh.new()
	for look: Material in tools:
		var tool: SurfaceTool = tools[look]
		tool.set_material(look)
		tool.commit(mesh_made)
	return mesh_made
