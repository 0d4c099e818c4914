extends RefCounted
## The look of a car: a lofted hull and a glazed cabin, lamps front and rear.

const Looks := preload("../build/looks.gd")

## Side view of the hull and the cabin: share of the length from the rear, share of the height.
const HULL: Array[Vector2] = [
	Vector2(0.0, 0.2),
	Vector2(0.0, 0.52),
	Vector2(0.04, 0.62),
	Vector2(0.2, 0.66),
	Vector2(0.7, 0.64),
	Vector2(0.95, 0.5),
	Vector2(1.0, 0.4),
	Vector2(1.0, 0.2)
]
const CABIN: Array[Vector2] = [
	Vector2(0.08, 0.64),
	Vector2(0.2, 0.96),
	Vector2(0.32, 1.0),
	Vector2(0.5, 0.99),
	Vector2(0.72, 0.64)
]


## A body of this length (x), height (y) and width (z), driving along +z.
static func mesh(size: Vector3, paint: Color) -> ArrayMesh:
	var out := ArrayMesh.new()
	_loft(out, HULL, size, 1.0, 0.94, Looks.plain(paint, 0.25))
	_loft(out, CABIN, size, 0.92, 0.72, Looks.glass())
	_slab(out, size, paint)
	_lamps(out, size)
	return out


## Extrudes a side view over the width, narrower toward its top.
static func _loft(
	into: ArrayMesh, outline: Array[Vector2], size: Vector3, low: float, high: float, look: Material
) -> void:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	tool.set_smooth_group(-1)
	var top := 0.0
	var bottom := 1.0
	for p in outline:
		top = maxf(top, p.y)
		bottom = minf(bottom, p.y)
	var left: Array[Vector3] = []
	var right: Array[Vector3] = []
	for p in outline:
		var narrow := lerpf(low, high, (p.y - bottom) / (top - bottom))
		var half := 0.5 * size.z * narrow
		left.append(Vector3(half, p.y * size.y, (p.x - 0.5) * size.x))
		right.append(Vector3(-half, p.y * size.y, (p.x - 0.5) * size.x))
	for i in outline.size():
		var j := (i + 1) % outline.size()
		_quad(tool, left[i], right[i], right[j], left[j])
	for i in range(1, outline.size() - 1):
		_triangle(tool, left[0], left[i], left[i + 1])
		_triangle(tool, right[0], right[i + 1], right[i])
	tool.generate_normals()
	tool.set_material(look)
	tool.commit(into)


## The roof, painted, on top of the glass.
static func _slab(into: ArrayMesh, size: Vector3, paint: Color) -> void:
	var roof := BoxMesh.new()
	roof.size = Vector3(0.68 * size.z, 0.03 * size.y, 0.33 * size.x)
	_part(into, roof, Vector3(0.0, 0.995 * size.y, -0.15 * size.x), Looks.plain(paint, 0.25))


static func _lamps(into: ArrayMesh, size: Vector3) -> void:
	var lamp := BoxMesh.new()
	lamp.size = Vector3(0.2 * size.z, 0.07 * size.y, 0.02 * size.x)
	for side: float in [-0.34, 0.34]:
		var front := Vector3(side * size.z, 0.4 * size.y, 0.495 * size.x)
		var rear := Vector3(side * size.z, 0.48 * size.y, -0.495 * size.x)
		_part(into, lamp, front, Looks.plain(Color(0.95, 0.95, 0.85), 0.1))
		_part(into, lamp, rear, Looks.plain(Color(0.6, 0.02, 0.02), 0.2))


static func _part(into: ArrayMesh, part: PrimitiveMesh, at: Vector3, look: Material) -> void:
	var tool := SurfaceTool.new()
	tool.append_from(part, 0, Transform3D(Basis.IDENTITY, at))
	tool.set_material(look)
	tool.commit(into)


static func _quad(tool: SurfaceTool, a: Vector3, b: Vector3, c: Vector3, d: Vector3) -> void:
	_triangle(tool, a, b, c)
	_triangle(tool, a, c, d)


static func _triangle(tool: SurfaceTool, a: Vector3, b: Vector3, c: Vector3) -> void:
	tool.add_vertex(a)
	tool.add_vertex(c)
	tool.add_vertex(b)
