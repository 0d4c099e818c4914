extends RefCounted
## Many copies of one mesh. The buffer is set whole: a headless engine keeps that, and that alone.

const STRIDE := 12
const CUSTOM := 4


## `numbers`: for the labels of cameras, which of its thing's instances each is.
static func make(
	mesh: Mesh, places: Array[Transform3D], numbers := PackedInt32Array()
) -> MultiMesh:
	var multimesh := MultiMesh.new()
	multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh.use_custom_data = not numbers.is_empty()
	multimesh.mesh = mesh
	multimesh.instance_count = places.size()
	if not places.is_empty():
		multimesh.buffer = packed(places, numbers)
	return multimesh


## Three rows of four numbers for each place, and its number, if there are numbers.
static func packed(places: Array[Transform3D], numbers: PackedInt32Array) -> PackedFloat32Array:
	var out := PackedFloat32Array()
	for i in places.size():
		var place := places[i]
		var b := place.basis
		for row in 3:
			out.append_array([b.x[row], b.y[row], b.z[row], place.origin[row]])
		if not numbers.is_empty():
			out.append_array([numbers[i], 0.0, 0.0, 0.0])
	return out


static func places_of(multimesh: MultiMesh) -> Array[Transform3D]:
	var buffer := multimesh.buffer
	var stride := STRIDE + (CUSTOM if multimesh.use_custom_data else 0)
	var out: Array[Transform3D] = []
	for i in multimesh.instance_count:
		var row := buffer.slice(i * stride, (i + 1) * stride)
		var basis := Basis(
			Vector3(row[0], row[4], row[8]),
			Vector3(row[1], row[5], row[9]),
			Vector3(row[2], row[6], row[10])
		)
		out.append(Transform3D(basis, Vector3(row[3], row[7], row[11])))
	return out
