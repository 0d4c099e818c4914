extends RefCounted
## Many copies of one mesh. The buffer is set whole: a headless engine keeps that, and that alone.

const STRIDE := 12


static func make(mesh: Mesh, places: Array[Transform3D]) -> MultiMesh:
	var multimesh := MultiMesh.new()
	multimesh.transform_format = MultiMesh.TRANSFORM_3D
	multimesh.mesh = mesh
	multimesh.instance_count = places.size()
	if not places.is_empty():
		multimesh.buffer = packed(places)
	return multimesh


## Three rows of four numbers for each place.
static func packed(places: Array[Transform3D]) -> PackedFloat32Array:
	var out := PackedFloat32Array()
	for place in places:
		var b := place.basis
		for row in 3:
			out.append_array([b.x[row], b.y[row], b.z[row], place.origin[row]])
	return out


static func places_of(multimesh: MultiMesh) -> Array[Transform3D]:
	var buffer := multimesh.buffer
	var out: Array[Transform3D] = []
	for i in multimesh.instance_count:
		var row := buffer.slice(i * STRIDE, (i + 1) * STRIDE)
		var basis := Basis(
			Vector3(row[0], row[4], row[8]),
			Vector3(row[1], row[5], row[9]),
			Vector3(row[2], row[6], row[10])
		)
		out.append(Transform3D(basis, Vector3(row[3], row[7], row[11])))
	return out
