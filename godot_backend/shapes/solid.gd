extends RefCounted
## One mesh made of simple solids; those of one material become one surface.

## By material.
var _surfaces: Dictionary = {}


## What has one material.
class Surface:
	extends RefCounted
	var corners := PackedVector3Array()
	var normals := PackedVector3Array()
	var indices := PackedInt32Array()


## A box of this size (x, y, z) around a point.
func box(size: Vector3, at: Vector3, look: Material, turned := Basis.IDENTITY) -> void:
	var cuboid := BoxMesh.new()
	cuboid.size = size
	add(cuboid, Transform3D(turned, at), look)


## A cylinder or cone around a point, upright unless it is turned.
func cylinder(
	radii: Vector2,
	height: float,
	at: Vector3,
	look: Material,
	turned := Basis.IDENTITY,
	sides := 10
) -> void:
	var round_bar := CylinderMesh.new()
	round_bar.bottom_radius = radii.x
	round_bar.top_radius = radii.y
	round_bar.height = height
	round_bar.radial_segments = sides
	round_bar.rings = 1
	add(round_bar, Transform3D(turned, at), look)


## A ball around a point, scaled along the axes.
func ball(radii: Vector3, at: Vector3, look: Material, sides := 10) -> void:
	var sphere := SphereMesh.new()
	sphere.radius = 1.0
	sphere.height = 2.0
	sphere.radial_segments = sides
	sphere.rings = sides / 2 + 1
	add(sphere, Transform3D(Basis.from_scale(radii), at), look)


## A round bar from one point to another.
func bar(start: Vector3, end: Vector3, radius: float, look: Material, sides := 6) -> void:
	var along := end - start
	var side := Vector3.RIGHT if absf(along.normalized().x) < 0.9 else Vector3.UP
	var y := along.normalized()
	var z := side.cross(y).normalized()
	var turned := Basis(y.cross(z), y, z)
	cylinder(Vector2(radius, radius), along.length(), (start + end) * 0.5, look, turned, sides)


## A ring like a bicycle's wheel, its axle along x.
func ring(radius: float, thickness: float, at: Vector3, look: Material) -> void:
	var torus := TorusMesh.new()
	torus.inner_radius = radius - thickness
	torus.outer_radius = radius
	torus.rings = 20
	torus.ring_segments = 6
	add(torus, Transform3D(Basis(Vector3.BACK, PI / 2), at), look)


## A side view (z forward, y up, meters) drawn out over the width along x, which goes from `low` at
## its lowest point to `high` at its highest.
func loft(outline: PackedVector2Array, low: float, high: float, look: Material) -> void:
	var bottom := INF
	var top := -INF
	for p in outline:
		bottom = minf(bottom, p.y)
		top = maxf(top, p.y)
	var left := PackedVector3Array()
	for p in outline:
		var half := 0.5 * lerpf(low, high, (p.y - bottom) / maxf(top - bottom, 1e-6))
		left.append(Vector3(half, p.y, p.x))
	var turn := signf(_area(outline))
	for i in left.size():
		var a := left[i]
		var b := left[(i + 1) % left.size()]
		var out := Vector3(0.0, -(b.z - a.z), b.y - a.y) * turn
		pane([a, b, _mirrored(b), _mirrored(a)], out, look)
	var corners := Geometry2D.triangulate_polygon(outline)
	for i in range(0, corners.size(), 3):
		var side := [left[corners[i]], left[corners[i + 1]], left[corners[i + 2]]]
		pane(side, Vector3.RIGHT, look)
		pane(side.map(_mirrored), Vector3.LEFT, look)


## Adds a mesh, moved to its place.
func add(part: PrimitiveMesh, place: Transform3D, look: Material) -> void:
	var arrays := part.get_mesh_arrays()
	var surface := _surface(look)
	var first := surface.corners.size()
	var normals := place.basis.inverse().transposed()
	for vertex: Vector3 in arrays[Mesh.ARRAY_VERTEX]:
		surface.corners.append(place * vertex)
	for normal: Vector3 in arrays[Mesh.ARRAY_NORMAL]:
		surface.normals.append((normals * normal).normalized())
	for index: int in arrays[Mesh.ARRAY_INDEX]:
		surface.indices.append(first + index)


## Adds all of a mesh, moved; `look` instead of its own materials, if there is one.
func merge(other: ArrayMesh, at: Vector3, look: Material = null) -> void:
	for i in other.get_surface_count():
		var arrays := other.surface_get_arrays(i)
		var surface := _surface(other.surface_get_material(i) if look == null else look)
		var first := surface.corners.size()
		surface.corners.append_array(
			Transform3D(Basis.IDENTITY, at) * (arrays[Mesh.ARRAY_VERTEX] as PackedVector3Array)
		)
		surface.normals.append_array(arrays[Mesh.ARRAY_NORMAL])
		for index: int in arrays[Mesh.ARRAY_INDEX]:
			surface.indices.append(first + index)


## The mesh of all parts, turned.
func mesh(turned := Basis.IDENTITY) -> ArrayMesh:
	var out := ArrayMesh.new()
	for look: Material in _surfaces:
		var surface: Surface = _surfaces[look]
		var arrays := []
		arrays.resize(Mesh.ARRAY_MAX)
		var place := Transform3D(turned, Vector3.ZERO)
		arrays[Mesh.ARRAY_VERTEX] = place * surface.corners
		arrays[Mesh.ARRAY_NORMAL] = place * surface.normals
		arrays[Mesh.ARRAY_INDEX] = surface.indices
		out.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
		out.surface_set_material(out.get_surface_count() - 1, look)
	return out


## A flat convex face that looks `out`, roughly.
func pane(corners: Array, out: Vector3, look: Material) -> void:
	var surface := _surface(look)
	var first := surface.corners.size()
	var normal := ((corners[1] - corners[0]) as Vector3).cross(corners[2] - corners[0]).normalized()
	var is_front := normal.dot(out) < 0.0
	for corner: Vector3 in corners:
		surface.corners.append(corner)
		surface.normals.append(-normal if is_front else normal)
	for i in range(1, corners.size() - 1):
		surface.indices.append(first)
		surface.indices.append(first + (i if is_front else i + 1))
		surface.indices.append(first + (i + 1 if is_front else i))


func _surface(look: Material) -> Surface:
	if not _surfaces.has(look):
		_surfaces[look] = Surface.new()
	return _surfaces[look]


static func _mirrored(p: Vector3) -> Vector3:
	return Vector3(-p.x, p.y, p.z)


static func _area(outline: PackedVector2Array) -> float:
	var sum := 0.0
	for i in outline.size():
		sum += outline[i].cross(outline[(i + 1) % outline.size()])
	return sum
