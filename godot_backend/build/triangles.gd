extends "thing.gd"
## A flat shape of triangles on the ground.

const Protocol := preload("../net/protocol.gd")

## Its number in the table of the world.
var surface := 0

var _mesh: ArrayMesh


func build(reader: Reader) -> String:
	var count := reader.u16()
	var triangles := reader.u16()
	if count < 3 or triangles < 1:
		return "a shape has at least one triangle"
	var numbers := reader.floats(count * 3, Protocol.MAX_COORDINATE)
	var indices := PackedInt32Array()
	for i in triangles * 3:
		indices.append(reader.u16())
	if not reader.at_end():
		surface = reader.u8()
	if not reader.at_end():
		return "bad shape"
	for index in indices:
		if index >= count:
			return "a shape names a corner that it does not have"
	_add(numbers.to_byte_array().to_vector3_array(), indices)
	return ""


func content() -> PackedByteArray:
	var arrays := _mesh.surface_get_arrays(0)
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	return vertices.to_byte_array() + indices.to_byte_array()


## What it is made of.
func look() -> Material:
	return null


func _add(corners: PackedVector3Array, indices: PackedInt32Array) -> void:
	var normals := PackedVector3Array()
	normals.resize(corners.size())
	normals.fill(Vector3.UP)
	var uv := PackedVector2Array()
	for corner in corners:
		uv.append(Vector2(corner.x, corner.z))
	var uv2 := PackedVector2Array()
	uv2.resize(corners.size())
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = corners
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_TEX_UV] = uv
	arrays[Mesh.ARRAY_TEX_UV2] = uv2
	arrays[Mesh.ARRAY_INDEX] = indices
	_mesh = ArrayMesh.new()
	_mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	_mesh.surface_set_material(0, look())
	var instance := MeshInstance3D.new()
	instance.mesh = _mesh
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)
