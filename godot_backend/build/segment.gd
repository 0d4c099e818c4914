extends "thing.gd"
## A piece of road: a strip of lanes that look alike, drawn and solid; a raised one has curbs.

const Protocol := preload("../net/protocol.gd")
const Looks := preload("looks.gd")

const MIN_STATIONS := 2
const MAX_STATIONS := 340

static var _indices: Dictionary = {}

var _mesh: ArrayMesh


func build(reader: Reader) -> String:
	var lanes := reader.u8()
	var look := reader.u8()
	var left := reader.u8()
	var right := reader.u8()
	var raised := reader.u8() > 0
	var stations := reader.u16()
	var start := reader.f32(1e7)
	var spacing := reader.f32(1000.0)
	if stations < MIN_STATIONS or stations > MAX_STATIONS:
		return "a segment has %d to %d stations" % [MIN_STATIONS, MAX_STATIONS]
	var numbers := reader.floats(stations * 6, Protocol.MAX_COORDINATE)
	if not reader.at_end() or lanes < 1 or spacing <= 0.0:
		return "bad segment"
	var edges := numbers.to_byte_array().to_vector3_array()
	_add_mesh(edges, start, spacing, lanes, Looks.road(look & 15, left, right, look >> 4))
	if raised:
		_add_curb(edges, 0)
		_add_curb(edges, 1)
	add_body(_faces(edges), look >> 4)
	return ""


func content() -> PackedByteArray:
	var arrays := _mesh.surface_get_arrays(0)
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	return vertices.to_byte_array()


func _add_mesh(
	edges: PackedVector3Array, start: float, spacing: float, lanes: int, material: Material
) -> void:
	var normals := PackedVector3Array()
	normals.resize(edges.size())
	normals.fill(Vector3.UP)
	var uv := PackedVector2Array()
	var uv2 := PackedVector2Array()
	for i in edges.size() / 2:
		var half := edges[2 * i].distance_to(edges[2 * i + 1]) * 0.5
		var s := start + i * spacing
		uv.append(Vector2(half, s))
		uv.append(Vector2(-half, s))
		uv2.append(Vector2(half, lanes))
		uv2.append(Vector2(half, lanes))
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = edges
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_TEX_UV] = uv
	arrays[Mesh.ARRAY_TEX_UV2] = uv2
	arrays[Mesh.ARRAY_INDEX] = _strip(edges.size() / 2)
	_mesh = ArrayMesh.new()
	_mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	_mesh.surface_set_material(0, material)
	var instance := MeshInstance3D.new()
	instance.mesh = _mesh
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)


## The upright face of a raised strip along its left (0) or right (1) border, down to the ground.
func _add_curb(edges: PackedVector3Array, side: int) -> void:
	var face := PackedVector3Array()
	for i in edges.size() / 2:
		var top := edges[2 * i + side]
		var foot := Vector3(top.x, 0.0, top.z)
		face.append_array([foot, top] if side == 0 else [top, foot])
	# Lit as if it lay flat: it is too low for its own shade to matter.
	var normals := PackedVector3Array()
	normals.resize(face.size())
	normals.fill(Vector3.UP)
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = face
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_INDEX] = _strip(edges.size() / 2)
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, Looks.curb())
	var instance := MeshInstance3D.new()
	instance.mesh = mesh
	add_child(instance)


static func _faces(edges: PackedVector3Array) -> PackedVector3Array:
	var faces := PackedVector3Array()
	for index in _strip(edges.size() / 2):
		faces.append(edges[index])
	return faces


## Corners of the triangles of a strip, clockwise seen from above.
static func _strip(stations: int) -> PackedInt32Array:
	if not _indices.has(stations):
		var corners := PackedInt32Array()
		for i in stations - 1:
			var left := 2 * i
			corners.append_array([left, left + 2, left + 1, left + 1, left + 2, left + 3])
		_indices[stations] = corners
	return _indices[stations]
